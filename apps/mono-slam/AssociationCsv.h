// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monoslam_slam/FrameReport.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
/** associations.csv: what became of every landmark in view, a line a landmark and frame. */
class AssociationCsv
{
   public:
    explicit AssociationCsv(const std::string& folder);

    void write(const FrameReport& report);

   private:
    OutputFile file_;
};
}  // namespace monoslam
