// SPDX-License-Identifier: BSD-3-Clause
#include "ReadoutEstimator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "monoslam_models/projectOnTangent.h"
#include "monoslam_models/rowPose.h"

namespace monoslam
{
namespace
{
constexpr int kFewest = 12;  ///< pairs of a frame that say something beside the pose
constexpr double kForget =
    0.95;  ///< per frame: state and landmarks have yielded to the error so far
constexpr double kHuber_sigmas = 2.0;
constexpr double kLeastSigma_px = 0.2;  ///< of a residual
constexpr double kCertain_sigmas = 4.0;
constexpr double kShortest_s = 0.001;  ///< less is taken for a global shutter
constexpr double kLongest_s = 0.05;    ///< of a video camera
constexpr Eigen::Index kTau = 6;
}  // namespace

void ReadoutEstimator::startAt(double readout_s)
{
    information_ = 1.0 / (kShortest_s * kShortest_s);
    eta_ = information_ * readout_s;
}

void ReadoutEstimator::observe(const Belief& belief, const Camera& camera,
                               const std::vector<Association>& associations, double noise_px)
{
    const double sigma_px = std::max(noise_px, kLeastSigma_px);
    using namespace camera_state;
    const Vector13d x_v = belief.camera();
    const double used_s = camera.parameters().readout_s;
    Eigen::Matrix<double, 6, 1> rate;
    rate << x_v.segment<3>(kVelocity), x_v.segment<3>(kAngularVelocity);
    Eigen::Matrix<double, 7, 7> A = Eigen::Matrix<double, 7, 7>::Zero();
    Eigen::Matrix<double, 7, 1> b = Eigen::Matrix<double, 7, 1>::Zero();
    int count = 0;
    for (const Association& association : associations)
    {
        const Eigen::Index index = belief.find(association.id);
        if (association.fate != Fate::Matched || index < 0) continue;
        const auto& slot = belief.landmarks[static_cast<std::size_t>(index)];
        const auto row = poseAfter(x_v, rowTime_s(camera, association.z.y()));
        const auto projected =
            projectOnTangent(camera, ViewPose(row.pose),
                             LandmarkRay(slot.kind, belief.x.segment(slot.offset, slot.size())));
        if (!projected) continue;
        const double share = association.z.y() / camera.parameters().height_px - 0.5;
        Eigen::Matrix<double, 2, 7> J;
        J << projected->J_h_pose, share * (projected->J_h_pose * rate);
        const Eigen::Vector2d e = association.z - projected->h + J.col(kTau) * used_s;
        const double sigmas = (association.z - projected->h).norm() / sigma_px;
        const double weight =
            std::min(1.0, kHuber_sigmas / std::max(sigmas, 1e-9)) / (sigma_px * sigma_px);
        A += weight * J.transpose() * J;
        b += weight * J.transpose() * e;
        ++count;
    }
    if (count < kFewest) return;
    const Eigen::Matrix<double, 6, 6> A_pp = A.topLeftCorner<6, 6>();
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> ldlt(A_pp);
    const Eigen::Matrix<double, 6, 1> G = ldlt.solve(A.topRightCorner<6, 1>());
    information_ = kForget * information_ + A(kTau, kTau) - A.block<1, 6>(kTau, 0).dot(G);
    eta_ = kForget * eta_ + b(kTau) - G.dot(b.head<6>());
}

double ReadoutEstimator::readout_s() const
{
    if (!(information_ > 0.0)) return 0.0;
    const double tau = eta_ / information_;
    const double sigma = 1.0 / std::sqrt(information_);
    if (tau < std::max(kShortest_s, kCertain_sigmas * sigma)) return 0.0;
    return std::min(tau, kLongest_s);
}
}  // namespace monoslam
