// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/MeasurementEfficiency.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "monoslam_association/informationGain.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
InformationTarget informationTargetFrom(ConfigSection& section)
{
    return section.get<InformationTarget>(
        "mi_target", InformationTarget::State,
        {{"state", InformationTarget::State}, {"pose", InformationTarget::Pose}});
}

void listEfficiencies(const SequentialUpdate& update, InformationTarget target, double gate,
                      std::vector<MeasurementEfficiency>& list)
{
    std::optional<PoseInformation> pose;
    if (target == InformationTarget::Pose)
        pose.emplace(update.pose(), update.cameraCovariance().topLeftCorner<7, 7>());
    list.clear();
    for (const std::size_t i : update.open())
    {
        const OpenLandmark& landmark = update.landmarks()[i];
        const Eigen::Matrix2d& S = landmark.row.S;
        MeasurementEfficiency& entry = list.emplace_back();
        entry.landmark = i;
        entry.bits = pose ? (*pose)(landmark.C, S) : informationAboutState(S, landmark.row.R);
        const double area_px2 = M_PI * gate * std::sqrt(S.determinant());
        entry.bitsPerPixel2 = std::isfinite(entry.bits) ? entry.bits / area_px2 : 0.0;
        if (!(entry.bitsPerPixel2 > 0.0)) entry.bits = entry.bitsPerPixel2 = 0.0;
    }
}
}  // namespace monoslam
