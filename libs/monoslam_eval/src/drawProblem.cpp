// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/drawProblem.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "drawCandidates.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_eval/SyntheticWorld.h"
#include "monoslam_eval/drawMotion.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/ekf.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using namespace camera_state;

/** A frame that cannot be drawn so often never can. */
constexpr int kTries = 10000;
constexpr LandmarkId kDepths = 5;

/** One problem being drawn. */
class Draw
{
   public:
    Draw(const ProblemShape& shape, const ProblemDistributions& drawn, unsigned seed)
        : shape_(shape), d_(drawn), gate_(chi2Limit(2, drawn.gateProbability))
    {
        std::seed_seq all{static_cast<unsigned>(shape.landmarks),
                          static_cast<unsigned>(shape.candidates),
                          static_cast<unsigned>(shape.absent), seed};
        rng_.seed(all);
        frame_.visibility.sigma_px = d_.sigma_px;
        frame_.minScore = d_.minScore;
    }

    [[nodiscard]] RecordedFrame frame()
    {
        for (int tries = 0; tries < kTries; ++tries)
            if (const auto right = drawFrame()) return withCandidates(*right);
        throw std::invalid_argument("drawProblem: the landmarks never stay in view");
    }

   private:
    using Pixels = std::vector<Eigen::Vector2d>;

    double normal(double sigma) { return std::normal_distribution<double>(0.0, sigma)(rng_); }
    double uniform(double a, double b)
    {
        return std::uniform_real_distribution<double>(a, b)(rng_);
    }

    Belief camera()
    {
        Vector13d x_v = Vector13d::Zero();
        x_v(kOrientation) = 1.0;
        for (int i = 0; i < 3; ++i)
        {
            x_v(kVelocity + i) = normal(d_.speed_mps);
            x_v(kAngularVelocity + i) = normal(d_.turning_radps);
        }
        Matrix13d P_v = Matrix13d::Zero();
        const double halfAngle = 0.5 * d_.orientation_rad;  // dq = (1, dtheta / 2)
        P_v.diagonal().head<3>().setConstant(d_.position_m * d_.position_m);
        P_v.diagonal().segment<3>(kOrientation + 1).setConstant(halfAngle * halfAngle);
        P_v.diagonal().segment<3>(kVelocity).setConstant(d_.velocity_mps * d_.velocity_mps);
        P_v.diagonal()
            .segment<3>(kAngularVelocity)
            .setConstant(d_.turnRate_radps * d_.turnRate_radps);
        return Belief::ofCamera(x_v, P_v);
    }

    [[nodiscard]] double rho0(LandmarkId id) const
    {
        return d_.nearest_per_m * static_cast<double>(1 + id % kDepths) / kDepths;
    }

    Belief addLandmarks(Belief belief, const std::vector<NewLandmark>& corners) const
    {
        for (LandmarkId depth = 0; depth < kDepths; ++depth)
        {
            std::vector<NewLandmark> sameDepth;
            for (const NewLandmark& corner : corners)
                if (corner.id % kDepths == depth) sameDepth.push_back(corner);
            belief = addUndelayed(std::move(belief), frame_.camera, sameDepth,
                                  {rho0(depth), d_.rhoShare * rho0(depth), d_.sigma_px});
        }
        return belief;
    }

    /** First sighting of a landmark by the true camera: its pixel with noise. */
    NewLandmark sight(LandmarkId id, const Vector13d& truth, SyntheticWorld& world)
    {
        const CameraParameters& c = frame_.camera.parameters();
        const Eigen::Vector2d uv(uniform(d_.border_px, c.width_px - 1.0 - d_.border_px),
                                 uniform(d_.border_px, c.height_px - 1.0 - d_.border_px));
        const double rho = rho0(id) * (1.0 + normal(d_.rhoShare));
        const Eigen::Vector3d ray = frame_.camera.unproject(uv).value();
        const Eigen::Vector4d q_wc = truth.segment<4>(kOrientation);
        world.addLandmark(truth.head<3>() + rotate(q_wc, ray.normalized()) / rho);
        return {id, uv + Eigen::Vector2d(normal(d_.sigma_px), normal(d_.sigma_px))};
    }

    /** Fills belief and predictions; the right pixels, or nothing if one is out of its ellipse. */
    std::optional<Pixels> drawFrame()
    {
        const ConstantVelocityOptions motion;
        Belief belief = camera();
        Vector13d truth = drawCamera(belief.camera(), belief.P.topLeftCorner<13, 13>(), rng_);
        SyntheticWorldOptions options;
        options.camera = frame_.camera.parameters();
        options.sigma_px = d_.sigma_px;
        SyntheticWorld world(options, static_cast<unsigned>(rng_()));
        std::vector<NewLandmark> corners;
        for (int i = 0; i < shape_.landmarks; ++i) corners.push_back(sight(i, truth, world));
        belief = ekfPredict(addLandmarks(std::move(belief), corners), motion, d_.dt_s);
        truth = drawMotion(truth, d_.dt_s, motion, rng_);
        rows_ = predictMeasurements(belief, frame_.camera, frame_.visibility).rows;
        if (rows_.size() != corners.size()) return std::nullopt;
        Pixels right;
        for (const PredictedLandmark& row : rows_)
        {
            const auto z = world.measure(truth, row.id);
            if (!z || !inGate(row, *z)) return std::nullopt;
            right.push_back(*z);
        }
        frame_.mixture = {{std::move(belief), 0.0}};
        return right;
    }

    [[nodiscard]] bool inGate(const PredictedLandmark& row, const Eigen::Vector2d& z) const
    {
        const Eigen::Vector2d nu = z - row.h;
        return nu.dot(row.S.llt().solve(nu)) < gate_;
    }

    RecordedFrame withCandidates(const Pixels& right)
    {
        std::vector<std::size_t> order(right.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), rng_);
        std::vector<bool> absent(right.size(), false);
        for (int i = 0; i < shape_.absent; ++i) absent[order[static_cast<std::size_t>(i)]] = true;
        for (std::size_t i = 0; i < right.size(); ++i)
        {
            RecordedLandmark landmark;
            landmark.id = rows_[i].id;
            landmark.predicted = rows_[i];
            landmark.candidates =
                drawCandidates(rows_[i], {shape_.candidates, absent[i], right[i]}, d_, rng_);
            landmark.truth = -1;
            for (std::size_t c = 0; c < landmark.candidates.size(); ++c)
                if (landmark.candidates[c].z == right[i]) landmark.truth = static_cast<int>(c);
            frame_.landmarks.push_back(std::move(landmark));
        }
        return std::move(frame_);
    }

    ProblemShape shape_;
    ProblemDistributions d_;
    double gate_;
    std::mt19937 rng_;
    RecordedFrame frame_;
    std::vector<PredictedLandmark> rows_;
};
}  // namespace

RecordedFrame drawProblem(const ProblemShape& shape, unsigned seed,
                          const ProblemDistributions& drawn)
{
    if (shape.landmarks < 1 || shape.candidates < 1 || shape.absent < 0 ||
        shape.absent > shape.landmarks)
        throw std::invalid_argument(
            "drawProblem: needs a landmark, a candidate, and no more absent than landmarks");
    return Draw(shape, drawn, seed).frame();
}
}  // namespace monoslam
