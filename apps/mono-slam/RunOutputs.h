// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "AssociationCsv.h"
#include "Config.h"
#include "monoslam_slam/RunSummary.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
/** All files of a run: those that grow with every frame, and those of the end. */
class RunOutputs
{
   public:
    RunOutputs(const Config& config, const Arguments& arguments, const RawlogReader& reader);

    void add(const Frame& frame, const FrameReport& report, const MonoSlam& slam, double decode_ms);
    void finish(const MonoSlam& slam, bool interrupted);

    [[nodiscard]] const RunSummary& summary() const { return summary_; }
    [[nodiscard]] const std::string& lastRemark() const { return lastRemark_; }

   private:
    void addPicture(const Frame& frame, const FrameReport& report, const MonoSlam& slam);
    void writeTruth(const std::vector<RecordedPose>& poses) const;

    std::string folder_;
    OutputOptions options_;
    RunFacts facts_;
    RunSummary summary_;
    std::unique_ptr<FrameWriters> frames_;
    std::unique_ptr<AssociationCsv> associations_;  ///< only if asked for
    std::unique_ptr<OutputFile> robotPath_;
    mrpt::poses::CPose3D cameraPose_;  ///< on the vehicle
    std::vector<Vector7d> path_;
    std::set<LandmarkId> drawn_;  ///< landmarks of the picture before
    std::string lastRemark_;
};
}  // namespace monoslam
