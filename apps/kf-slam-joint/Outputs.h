// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "AssociationLog.h"
#include "Config.h"
#include "Filter.h"
#include "StepPairs.h"

namespace monoslam
{
/** The files that kf-slam writes, and estimated_path.tum besides. */
class Outputs
{
   public:
    /** Empties the folder of such files only, and only with force.
     *  \throw std::runtime_error naming the folder */
    Outputs(const Config& config, bool force);

    void add(const Step& step, const Filter& filter);
    [[nodiscard]] const std::vector<mrpt::poses::CPose3D>& path() const { return path_; }
    /** Of the file, or none; truth()[frames()[i]] belongs to path()[i]. */
    [[nodiscard]] const std::vector<mrpt::poses::CPose3D>& truth() const { return truth_; }
    [[nodiscard]] const std::vector<std::size_t>& frames() const { return frames_; }
    /** Whether any observation bore an ID. */
    [[nodiscard]] bool haveIds() const { return haveIds_; }

   private:
    [[nodiscard]] std::string file(const char* format) const;
    void saveState(const Filter& filter) const;
    void saveScene(const Filter& filter) const;

    const Config& config_;
    std::string folder_;
    std::unique_ptr<OutputFile> trajectory_;
    std::unique_ptr<AssociationLog> log_;
    std::vector<mrpt::poses::CPose3D> path_, truth_;
    std::vector<std::size_t> frames_;  ///< of the steps of the path
    bool haveIds_ = false;
};
}  // namespace monoslam
