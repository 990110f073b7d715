// SPDX-License-Identifier: BSD-3-Clause
#include "Verdicts.h"

#include <limits>

namespace monoslam
{
namespace
{
constexpr double kWrong_px = 3.0;

double share(long part, long whole)
{
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole)
                     : std::numeric_limits<double>::quiet_NaN();
}
}  // namespace

void Verdicts::add(bool wrong, bool rejected)
{
    ++(wrong ? (rejected ? wrongRejected : wrongAccepted)
             : (rejected ? rightRejected : rightAccepted));
}

long Verdicts::pairs() const
{
    return rightAccepted + wrongAccepted + rightRejected + wrongRejected;
}

double Verdicts::precision() const
{
    return share(wrongRejected, wrongRejected + rightRejected);
}
double Verdicts::recall() const
{
    return share(wrongRejected, wrongRejected + wrongAccepted);
}

bool DepthJudge::isWrong(const Association& pair, long frame)
{
    const auto point = points_.find(pair.id);
    if (point == points_.end()) return false;
    const auto truth = world_.pixel(frame, point->second);
    return !truth || (pair.z - *truth).norm() > kWrong_px;
}

void DepthJudge::note(const std::vector<MapLandmark>& map)
{
    for (const MapLandmark& landmark : map)
    {
        if (points_.count(landmark.id) > 0) continue;
        if (const auto point = world_.point(landmark.bornFrame, landmark.born_px))
            points_[landmark.id] = *point;
    }
}

bool MotionJudge::isWrong(const Association& pair, long frame)
{
    return frame >= object_.firstMoving && object_.contains(frame, pair.z.x(), pair.z.y());
}
}  // namespace monoslam
