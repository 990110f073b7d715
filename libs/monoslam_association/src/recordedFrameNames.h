// SPDX-License-Identifier: BSD-3-Clause
// The words of the format of recordedFrameFile.h that its two directions share.
#pragma once

#include <array>
#include <utility>

#include "monoslam_association/RecordedFrame.h"

namespace monoslam
{
inline constexpr const char* kFormatName = "monoslam association problem";
inline constexpr int kFormatVersion = 1;

inline constexpr std::array<std::pair<const char*, LandmarkKind>, 2> kKindNames{
    {{"inverse_depth", LandmarkKind::InverseDepth}, {"point", LandmarkKind::Point}}};

inline constexpr std::array<std::pair<const char*, SearchStatus>, 3> kStatusNames{
    {{"done", SearchStatus::Done},
     {"unpredictable", SearchStatus::Unpredictable},
     {"refused", SearchStatus::Refused}}};

inline constexpr std::array<DistortionModel, 5> kDistortionModels{
    DistortionModel::None, DistortionModel::Brown, DistortionModel::KannalaBrandt,
    DistortionModel::Tsai, DistortionModel::Davison};
}  // namespace monoslam
