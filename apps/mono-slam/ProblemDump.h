// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "monoslam_slam/MonoSlam.h"

namespace monoslam
{
/** Association problems of some frames as files, --dump-association and --dump-frames. */
class ProblemDump
{
   public:
    /** \param folder  empty: nothing is written; \param frames  "7,100-120", empty = all
     *  \throw std::exception naming the option or the folder that is no good */
    ProblemDump(std::string folder, const std::string& frames, bool force);

    /** From now on every chosen frame is written; this object must live as long as \p slam runs. */
    void attachTo(MonoSlam& slam);

   private:
    [[nodiscard]] bool chosen(long frame) const;

    std::string folder_;
    bool force_;
    std::vector<std::pair<long, long>> frames_;  ///< first and last of each range
};
}  // namespace monoslam
