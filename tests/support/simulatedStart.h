// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "StartWindow.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

/** The first seconds of a run without images: true pixels plus noise, and a filter that may be
 *  wrong in any way. */
namespace monoslam
{
enum class Guess
{
    Right,     ///< depths and poses nearly true
    Mirrored,  ///< near and far exchanged, the motion reversed, a rotation that hides both
    Still,     ///< one depth for all, no motion, a rotation instead: there is no parallax to see
};

struct SimulatedStartOptions
{
    Guess guess = Guess::Right;
    bool metric = false;  ///< the first landmarks are known points
    int known = 6;
    double knownTurn_rad = 0.0;  ///< by which the filter has turned them about the first camera
    double sigma_px = 0.3;
    double wildShare = 0.0;             ///< of the pixels after the first frame, which are anywhere
    Fate fate = Fate::Matched;          ///< of every pixel
    int inViewAtTheEnd = 40;            ///< of the landmarks, from the tenth frame on
    std::vector<LandmarkId> wandering;  ///< these move half a pixel a frame across the others
    StartOptions start = {{4.0}};
};

class SimulatedStart
{
   public:
    static constexpr int kLandmarks = 40;
    static constexpr double kStep_s = 1.0 / 30.0;
    static constexpr ConstantVelocityOptions kMotion{NoiseForm::Density, 0.01, 0.01};

    SimulatedStart(SimulatedStartOptions options, unsigned seed)
        : options_(std::move(options)),
          rng_(seed),
          window_(options_.start, camera_, options_.metric)
    {
        for (int i = 0; i < kLandmarks; ++i) addLandmark(i);
    }

    /** The camera's true pose in frame k: 5 mm a frame to the right, a little of all else. */
    [[nodiscard]] static Vector7d truePose(int k)
    {
        Vector7d pose;
        pose << 0.005 * k, 0.01 * std::sin(0.1 * k), 0.001 * k,
            quaternionExp({0.02 * std::sin(0.07 * k), -0.003 * k, 0.002 * k});
        return pose;
    }

    /** Its true mean velocities from the frame before, in a world that is s times as large. */
    [[nodiscard]] static Eigen::Matrix<double, 6, 1> meanVelocity(int k, double s)
    {
        const Vector7d before = truePose(k - 1);
        const Vector7d last = truePose(k);
        Eigen::Matrix<double, 6, 1> v;
        v << s * (last - before).head<3>(),
            quaternionLog(quaternionProduct(quaternionConjugate(before.tail<4>()), last.tail<4>()));
        return v / kStep_s;
    }

    /** Frame after frame until the window gives a belief; nothing if it does not within 100. */
    std::optional<RefinedStart> run()
    {
        std::optional<RefinedStart> refined;
        while (!refined && frame_ + 1 < 100) refined = step();
        return refined;
    }

    /** One frame. \return what the window makes of it */
    std::optional<RefinedStart> step()
    {
        ++frame_;
        belief_.x.head<7>() = guessedPose(frame_);
        window_.record(frame_ * kStep_s, frame_, belief_, frame_ == 0 ? none() : see(), records_,
                       options_.sigma_px);
        return window_.refine(belief_, records_, kMotion);
    }

    /** From now on the filter errs like this, as if it had from the beginning but for what the window
     *  has seen of it. */
    void misguide(Guess guess)
    {
        options_.guess = guess;
        for (const auto& slot : belief_.landmarks)
            if (slot.kind == LandmarkKind::InverseDepth)
                belief_.x(slot.offset + inverse_depth::kRho) = guessedRho(slot.id);
    }

    [[nodiscard]] const StartWindow& window() const { return window_; }
    [[nodiscard]] int frame() const { return frame_; }
    [[nodiscard]] const Eigen::Vector3d& point(LandmarkId id) const
    {
        return points_[static_cast<std::size_t>(id)];
    }

   private:
    static std::vector<Association> none() { return {}; }

    Eigen::Vector2d measured(LandmarkId id, int k)
    {
        if (k > 0 && uniform(rng_, 0.0, 1.0) < options_.wildShare)
            return {uniform(rng_, 0.0, 640.0), uniform(rng_, 0.0, 480.0)};
        const Vector7d pose = truePose(k);
        Eigen::Vector2d uv =
            *camera_.project(rotateInverse(pose.tail<4>(), point(id) - pose.head<3>()));
        const auto& wandering = options_.wandering;
        if (std::count(wandering.begin(), wandering.end(), id) > 0) uv.y() += 0.5 * k;
        return uv + normalVector<2>(rng_, options_.sigma_px);
    }

    void addLandmark(LandmarkId id)
    {
        const Eigen::Vector3d ray(uniform(rng_, -0.4, 0.5), uniform(rng_, -0.35, 0.35), 1.0);
        points_.push_back(uniform(rng_, 0.7, 2.0) * ray);
        LandmarkRecord record;
        record.born.uv_px = measured(id, 0);
        if (options_.metric && id < options_.known) record.known = point(id);
        records_[id] = record;
        if (record.known)
            belief_ = addPoint(std::move(belief_), id,
                               rotate(quaternionExp({0.0, options_.knownTurn_rad, 0.0}), point(id)),
                               1e-8 * Eigen::Matrix3d::Identity());
        else
            belief_ = *addUndelayed(std::move(belief_), camera_, id, record.born.uv_px,
                                    {guessedRho(id), 0.3, options_.sigma_px});
    }

    double guessedRho(LandmarkId id)
    {
        const double rho = 1.0 / point(id).norm();
        if (options_.guess == Guess::Mirrored) return 2.0 * kMiddleRho - rho;
        if (options_.guess == Guess::Still) return kMiddleRho;
        return rho * std::exp(uniform(rng_, -0.1, 0.1));
    }

    [[nodiscard]] Vector7d guessedPose(int k)
    {
        Vector7d pose = truePose(k);
        if (k == 0) return pose;
        Eigen::Vector3d turn = normalVector<3>(rng_, 1e-3);
        if (options_.guess != Guess::Right)
        {
            const double wrong = options_.guess == Guess::Mirrored ? 2.0 : 1.0;  // times the motion
            turn += wrong * kMiddleRho * Eigen::Vector3d(-pose.y(), pose.x(), 0.0);
            pose.head<3>() *= 1.0 - wrong;
        }
        pose.tail<4>() = quaternionProduct(pose.tail<4>(), quaternionExp(turn));
        return pose;
    }

    std::vector<Association> see()
    {
        std::vector<Association> seen;
        const int count = frame_ < 10 ? kLandmarks : options_.inViewAtTheEnd;
        for (LandmarkId id = 0; id < count; ++id)
        {
            Association association;
            association.id = id;
            association.fate = options_.fate;
            association.z = measured(id, frame_);
            association.R = options_.sigma_px * options_.sigma_px * Eigen::Matrix2d::Identity();
            seen.push_back(association);
        }
        return seen;
    }

    static constexpr double kMiddleRho = 0.85;
    static Belief cameraAtRest()
    {
        Vector13d x_v = Vector13d::Zero();
        x_v.head<7>() = truePose(0);
        return Belief::ofCamera(x_v, 1e-6 * Matrix13d::Identity());
    }

    SimulatedStartOptions options_;
    Camera camera_;
    std::mt19937 rng_;
    StartWindow window_;
    std::vector<Eigen::Vector3d> points_;
    LandmarkRecords records_;
    Belief belief_ = cameraAtRest();
    int frame_ = -1;
};
}  // namespace monoslam
