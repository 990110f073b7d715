// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <stdexcept>

#include "monoslam_association/RecordedFrame.h"

namespace monoslam
{
namespace
{
/** Of a number's size: another compiler's rounding passes, another belief or camera does not. */
constexpr double kTolerance = 1e-6;

void compare(LandmarkId id, const char* quantity, const Eigen::MatrixXd& recorded,
             const Eigen::MatrixXd& predicted)
{
    const double difference = (recorded - predicted).cwiseAbs().maxCoeff();
    if (difference <= kTolerance * (1.0 + predicted.cwiseAbs().maxCoeff())) return;
    throw std::invalid_argument("landmark " + std::to_string(id) + ": " + quantity +
                                " is not what belief and camera predict: it differs by " +
                                std::to_string(difference));
}
}  // namespace

void RecordedFrame::check() const
{
    for (const WeightedBelief& weighted : mixture)
    {
        try
        {
            weighted.belief.checkInvariant();
        }
        catch (const std::logic_error& error)
        {
            throw std::invalid_argument(error.what());
        }
    }
    if (mixture.empty()) throw std::invalid_argument("no belief");
    std::map<LandmarkId, PredictedLandmark> byId;
    for (PredictedLandmark& row : predictMeasurements(best(mixture), camera, visibility).rows)
        byId[row.id] = row;
    for (const RecordedLandmark& landmark : landmarks)
    {
        const auto row = byId.find(landmark.id);
        if (landmark.predicted.has_value() != (row != byId.end()))
            throw std::invalid_argument(
                "landmark " + std::to_string(landmark.id) +
                (row == byId.end() ? ": is recorded as visible and is not, by belief and camera"
                                   : ": is recorded as not visible and is, by belief and camera"));
        if (!landmark.predicted) continue;
        const PredictedLandmark& there = *landmark.predicted;
        compare(landmark.id, "h", there.h, row->second.h);
        compare(landmark.id, "H_v", there.H_v, row->second.H_v);
        compare(landmark.id, "H_y", there.H_y.leftCols(there.size),
                row->second.H_y.leftCols(row->second.size));
        compare(landmark.id, "S", there.S, row->second.S);
    }
}
}  // namespace monoslam
