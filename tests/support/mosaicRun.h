// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>

#include "MapKeeper.h"
#include "mosaic.h"

/** A MapKeeper at work on the images of a camera whose poses are known. */
namespace monoslam
{
inline constexpr double kSide_m = 0.09;
inline constexpr int kFrames = 11;

/** Frame k of a camera half a metre above the plane that moves sideways, a centimetre a frame. */
inline Vector7d poseOf(int k)
{
    return lookAt({-0.06 + 0.01 * k, -0.2, 0.45}, {0.005 * k, 0.02, 0.0}, 0.005 * k);
}

inline std::shared_ptr<const PreparedImage> frameOf(int k)
{
    static std::map<int, std::shared_ptr<const PreparedImage>> rendered;  // once for all runs
    auto& frame = rendered[k];
    Sensor sensor;
    sensor.seed = static_cast<unsigned>(k + 1);
    if (!frame)
        frame = prepareImage(renderPlane(mosaic(kSide_m), smallCamera(), poseOf(k), sensor), 0.7);
    return frame;
}

/** The map of a camera whose poses are known exactly and that sees a mosaic on z = 0. */
class MosaicRun
{
   public:
    /** \param later  by how much all poses are found to be elsewhere after the first frame */
    explicit MosaicRun(const MonoSlamOptions& options,
                       const Eigen::Vector3d& later = Eigen::Vector3d::Zero())
        : later_(later), keeper_(options, camera_, 1)
    {
        Vector13d x_v = Vector13d::Zero();
        x_v.head<7>() = poseOf(0);
        mixture_ = {{Belief::ofCamera(x_v, 1e-12 * Matrix13d::Identity()), 0.0}};
    }

    void step(int k)
    {
        Belief& known = mixture_.front().belief;
        known.x.head<7>() = poseOf(k);
        if (k > 0) known.x.head<3>() += later_;
        for (const auto& clone : known.clones)
            if (k == 1) known.x.segment<3>(clone.offset) += later_;
        mixture_ = keeper_.revise(std::move(mixture_), {}, {frameOf(k), k});
        belief().checkInvariant();
    }

    [[nodiscard]] const Belief& belief() const { return mixture_.front().belief; }
    [[nodiscard]] const MapKeeper& keeper() const { return keeper_; }

   private:
    Eigen::Vector3d later_;
    Camera camera_ = smallCamera();
    MapKeeper keeper_;
    Mixture mixture_;
};
}  // namespace monoslam
