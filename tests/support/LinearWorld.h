// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "monoslam_association/Associator.h"
#include "monoslam_filter/editBelief.h"

namespace monoslam::test
{
/** A camera that moves over a flat drawing: h = y.xy + r.xy, landmarks are points.
 *
 * The camera's position is uncertain by 15 px, each landmark by 1 px, a pixel by sigma_px. */
struct LinearWorld
{
    Belief belief;
    std::map<LandmarkId, std::vector<Candidate>> seen;  ///< best score first
    double sigma_px = 0.5;

    static LinearWorld withLandmarks(int count, unsigned seed, double sigma_px = 0.5);

    [[nodiscard]] Prediction predict(const Belief& at) const;
    [[nodiscard]] PredictedLandmark linearize(const Eigen::VectorXd& x,
                                              const LandmarkSlot& slot) const;
    [[nodiscard]] SearchResult search(const SearchRegion& region) const;
    [[nodiscard]] FrameView view() const
    {
        FrameView view;
        view.predict = [this](const Belief& at) { return predict(at); };
        view.linearize = [this](const Eigen::VectorXd& x, const LandmarkSlot& slot)
        { return linearize(x, slot); };
        view.search = [this](const SearchRegion& region) { return search(region); };
        return view;
    }
    /** The same belief with its landmarks in the opposite order. */
    [[nodiscard]] LinearWorld reversed() const;
    [[nodiscard]] Eigen::Matrix2d R() const
    {
        return sigma_px * sigma_px * Eigen::Matrix2d::Identity();
    }
    void displace(LandmarkId id, const Eigen::Vector2d& error_px)
    {
        seen.at(id).front().z += error_px;
    }
};

inline LinearWorld LinearWorld::withLandmarks(int count, unsigned seed, double sigma_px)
{
    std::mt19937 rng(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> u(20.0, 620.0), v(20.0, 460.0);
    LinearWorld world;
    world.sigma_px = sigma_px;
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    Matrix13d P_v = 1e-6 * Matrix13d::Identity();
    P_v(0, 0) = P_v(1, 1) = 15.0 * 15.0;
    world.belief = Belief::ofCamera(x_v, P_v);
    const Eigen::Vector2d motion(15.0 * normal(rng), 15.0 * normal(rng));
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector3d y(u(rng), v(rng), 0.0);
        world.belief = addPoint(std::move(world.belief), i, y, Eigen::Matrix3d::Identity());
        const double sigma = std::sqrt(1.0 + sigma_px * sigma_px);
        const Eigen::Vector2d z =
            y.head<2>() + motion + sigma * Eigen::Vector2d(normal(rng), normal(rng));
        world.seen[i] = {{z, 0.9 + 0.001 * i, world.R()}};
    }
    return world;
}

inline PredictedLandmark LinearWorld::linearize(const Eigen::VectorXd& x,
                                                const LandmarkSlot& slot) const
{
    PredictedLandmark row;
    row.id = slot.id;
    row.offset = slot.offset;
    row.size = slot.size();
    row.H_v.setZero();
    row.H_y.setZero();
    row.H_v.leftCols<2>().setIdentity();
    row.H_y.leftCols<2>().setIdentity();
    row.h = x.head<2>() + x.segment<2>(slot.offset);
    row.R = R();
    return row;
}

inline Prediction LinearWorld::predict(const Belief& at) const
{
    Prediction prediction;
    const auto m = static_cast<Eigen::Index>(at.landmarks.size());
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * m, at.size());
    for (Eigen::Index i = 0; i < m; ++i)
    {
        const LandmarkSlot& slot = at.landmarks[static_cast<std::size_t>(i)];
        H.block<2, 2>(2 * i, 0).setIdentity();
        H.block<2, 2>(2 * i, slot.offset).setIdentity();
        prediction.rows.push_back(linearize(at.x, slot));
    }
    prediction.PHt = at.P * H.transpose();
    prediction.HPHt = H * prediction.PHt;
    for (Eigen::Index i = 0; i < m; ++i)
    {
        PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
        row.S = prediction.HPHt.block<2, 2>(2 * i, 2 * i) + row.R;
    }
    return prediction;
}

inline SearchResult LinearWorld::search(const SearchRegion& region) const
{
    SearchResult result;
    result.pixels = 100;
    const auto entry = seen.find(region.id);
    if (entry == seen.end()) return result;
    for (const Candidate& candidate : entry->second)
    {
        const Eigen::Vector2d nu = candidate.z - region.centre;
        const bool outside = nu.dot(region.S.ldlt().solve(nu)) > region.gate;
        if (outside || static_cast<int>(result.candidates.size()) >= region.maxCandidates) continue;
        result.candidates.push_back(candidate);
    }
    return result;
}

inline LinearWorld LinearWorld::reversed() const
{
    LinearWorld other = *this;
    std::reverse(other.belief.landmarks.begin(), other.belief.landmarks.end());
    for (std::size_t i = 0; i < belief.landmarks.size(); ++i)
    {
        LandmarkSlot& to = other.belief.landmarks[i];
        const LandmarkSlot& from = belief.landmarks[belief.landmarks.size() - 1 - i];
        to.offset = belief.landmarks[i].offset;
        other.belief.x.segment<3>(to.offset) = belief.x.segment<3>(from.offset);
        other.belief.P.block<3, 3>(to.offset, to.offset) =
            belief.P.block<3, 3>(from.offset, from.offset);
    }
    return other;
}

/** Two landmarks of two candidates each, all of which may be right. */
inline LinearWorld ambiguousWorld(unsigned seed)
{
    LinearWorld world = LinearWorld::withLandmarks(2, seed);
    for (auto& [id, candidates] : world.seen)
        candidates.push_back(
            {candidates.front().z + Eigen::Vector2d(6.0, -5.0 + 2.0 * id), 0.85, 0.5 * world.R()});
    return world;
}
}  // namespace monoslam::test
