// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <map>
#include <set>

#include "exampleCameras.h"
#include "monoslam_association/Associator.h"
#include "monoslam_models/quaternion.h"
#include "randomBelief.h"

namespace monoslam::test
{
struct PerspectiveFrameOptions
{
    int inverseDepths = 20;
    int points = 20;
    bool clone = false;
    double sigma_px = 0.5;
    double wrongShare = 0.0;  ///< of the landmarks whose only candidate is wrong
    int clutter = 0;          ///< wrong candidates beside the right one, anywhere in the ellipse
    bool settled = false;     ///< well-known landmarks, a motion that turns more than it moves
};

/** A belief, a truth drawn from it, and what a camera there sees of its landmarks. Wrong candidates
 *  lie in the landmark's ellipse, further than 6 sigma_px from where it is seen. */
struct PerspectiveFrame
{
    Camera camera{cameraParameters(DistortionModel::Brown, {-0.28, 0.07, 1e-3, -5e-4, -0.008})};
    VisibilityOptions visibility;
    Belief belief;
    Eigen::VectorXd truth;
    std::map<LandmarkId, std::vector<Candidate>> seen;  ///< the right one first, unless wrong
    std::set<LandmarkId> wrong;

    PerspectiveFrame(const PerspectiveFrameOptions& options, unsigned seed)
    {
        std::mt19937 rng(seed);
        visibility.sigma_px = options.sigma_px;
        belief = randomBelief(rng, camera, {options.inverseDepths, options.points, options.clone});
        if (options.settled) settle();
        truth = drawState(rng);
        const Prediction prediction = predictMeasurements(belief, camera, visibility);
        std::size_t left = prediction.rows.size();
        auto wrongLeft =
            static_cast<std::size_t>(options.wrongShare * static_cast<double>(left) + 0.5);
        for (const PredictedLandmark& row : prediction.rows)
        {
            const bool isWrong = uniform(rng, 0.0, 1.0) * static_cast<double>(left--) <
                                 static_cast<double>(wrongLeft);
            if (!see(row, isWrong ? 1 : options.clutter, rng) || !isWrong) continue;
            wrong.insert(row.id);
            --wrongLeft;
            seen[row.id].erase(seen[row.id].begin());
        }
    }

    [[nodiscard]] FrameView view() const
    {
        FrameView view;
        view.predict = [this](const Belief& at)
        { return predictMeasurements(at, camera, visibility); };
        view.linearize = [this](const Eigen::VectorXd& x, const LandmarkSlot& slot)
        { return linearizeLandmark(x, slot, camera, visibility); };
        view.search = [this](const SearchRegion& region) { return search(region); };
        return view;
    }

    [[nodiscard]] SearchResult search(const SearchRegion& region) const
    {
        SearchResult result;
        result.pixels = 100;
        const auto entry = seen.find(region.id);
        if (entry == seen.end()) return result;
        const Eigen::Matrix2d precision = region.S.inverse();
        for (const Candidate& candidate : entry->second)
        {
            const Eigen::Vector2d nu = candidate.z - region.centre;
            if (nu.dot(precision * nu) < region.gate &&
                static_cast<int>(result.candidates.size()) < region.maxCandidates)
                result.candidates.push_back(candidate);
        }
        return result;
    }

   private:
    /** Standard deviations of landmarks and position are a tenth, of the orientation 0.15: a frame of a
     *  camera at 30 fps. */
    void settle()
    {
        Eigen::VectorXd scale = Eigen::VectorXd::Constant(belief.size(), 0.1);
        scale.segment<4>(camera_state::kOrientation).setConstant(0.15);
        belief.P = (scale.asDiagonal() * belief.P * scale.asDiagonal()).eval();
    }

    Eigen::VectorXd drawState(std::mt19937& rng) const
    {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(belief.P);
        Eigen::VectorXd n(belief.size());
        std::normal_distribution<double> normal;
        for (double& number : n) number = normal(rng);
        Eigen::VectorXd x =
            belief.x +
            solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().cwiseProduct(n);
        x.segment<4>(3).normalize();
        return x;
    }

    /** False if the landmark is not in view from the truth. */
    bool see(const PredictedLandmark& row, int clutter, std::mt19937& rng)
    {
        const LandmarkSlot& slot = belief.landmarks[static_cast<std::size_t>(belief.find(row.id))];
        const auto there = projectPixel(camera, truth.head<13>(), slot.kind,
                                        truth.segment(slot.offset, slot.size()));
        if (!there) return false;
        const Eigen::Vector2d z = *there + normalVector<2>(rng, visibility.sigma_px);
        std::vector<Candidate>& candidates = seen[row.id];
        candidates.push_back({z, 0.95, row.R});
        const double apart_px = 6.0 * visibility.sigma_px;
        const Eigen::Matrix2d L = row.S.llt().matrixL();
        while (clutter-- > 0)
        {
            Eigen::Vector2d other = z;
            for (int tries = 0; tries < 100 && (other - z).norm() < apart_px; ++tries)
                other = row.h + 2.4 * L * uniformVector<2>(rng, 0.7);
            if ((other - z).norm() < apart_px)  // the ellipse is too small
                other = z + apart_px * normalVector<2>(rng, 1.0).normalized();
            candidates.push_back({other, 0.85, row.R});
        }
        return true;
    }
};
}  // namespace monoslam::test
