// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/Belief.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace monoslam
{
namespace
{
constexpr double kSymmetryTolerance = 1e-9;
constexpr double kNormTolerance = 1e-9;

std::vector<std::pair<Eigen::Index, Eigen::Index>> blocksOf(const Belief& belief)
{
    std::vector<std::pair<Eigen::Index, Eigen::Index>> blocks{{0, camera_state::kSize}};
    for (const auto& slot : belief.landmarks) blocks.emplace_back(slot.offset, slot.size());
    for (const auto& slot : belief.clones)
        blocks.emplace_back(slot.offset, camera_state::kPoseSize);
    std::sort(blocks.begin(), blocks.end());
    return blocks;
}
}  // namespace

Belief Belief::ofCamera(const Vector13d& x_v, const Matrix13d& P_v)
{
    Belief belief;
    belief.x = x_v;
    belief.P = P_v;
    return belief;
}

Eigen::Index Belief::find(LandmarkId id) const
{
    const auto it = std::find_if(landmarks.begin(), landmarks.end(),
                                 [id](const LandmarkSlot& slot) { return slot.id == id; });
    return it == landmarks.end() ? -1 : it - landmarks.begin();
}

const CloneSlot* Belief::findClone(CloneId id) const
{
    const auto it = std::find_if(clones.begin(), clones.end(),
                                 [id](const CloneSlot& slot) { return slot.id == id; });
    return it == clones.end() ? nullptr : &*it;
}

void Belief::checkInvariant() const
{
    if (P.rows() != size() || P.cols() != size()) throw std::logic_error("Belief: P is not N x N");
    Eigen::Index next = 0;
    for (const auto& [offset, length] : blocksOf(*this))
    {
        if (offset != next) throw std::logic_error("Belief: blocks overlap or leave a gap");
        next = offset + length;
    }
    if (next != size()) throw std::logic_error("Belief: the blocks do not cover the state");
    if (!x.allFinite() || !P.allFinite()) throw std::logic_error("Belief: not finite");
    const double scale = 1.0 + P.cwiseAbs().maxCoeff();
    if ((P - P.transpose()).cwiseAbs().maxCoeff() > kSymmetryTolerance * scale)
        throw std::logic_error("Belief: P is not symmetric");
    const auto unit = [this](Eigen::Index pose)
    {
        const double norm = x.segment<4>(pose + camera_state::kOrientation).norm();
        return std::abs(norm - 1.0) < kNormTolerance;
    };
    if (!unit(0)) throw std::logic_error("Belief: the camera's quaternion is not of unit length");
    for (const auto& slot : clones)
        if (!unit(slot.offset))
            throw std::logic_error("Belief: a clone's quaternion is not of unit length");
}

std::size_t bestIndex(const Mixture& mixture)
{
    if (mixture.empty()) throw std::logic_error("best(): empty mixture");
    const auto heavier = [](const WeightedBelief& a, const WeightedBelief& b)
    { return a.logWeight < b.logWeight; };
    const auto heaviest = std::max_element(mixture.begin(), mixture.end(), heavier);
    return static_cast<std::size_t>(heaviest - mixture.begin());
}

const Belief& best(const Mixture& mixture)
{
    return mixture[bestIndex(mixture)].belief;
}

Belief& best(Mixture& mixture)
{
    return mixture[bestIndex(mixture)].belief;
}
}  // namespace monoslam
