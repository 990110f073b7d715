// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "MapKeeper.h"
#include "monoslam_filter/editBelief.h"
#include "texture.h"

/** A MapKeeper, its mixture and its frames: what MonoSlam holds, without search in the image. */
namespace monoslam
{
inline constexpr int kKeptWidth_px = 320;
inline constexpr int kKeptHeight_px = 240;

inline Camera keptCamera()
{
    CameraParameters p;
    p.width_px = kKeptWidth_px;
    p.height_px = kKeptHeight_px;
    p.fx_px = p.fy_px = 260.0;
    p.cx_px = 159.5;
    p.cy_px = 119.5;
    return Camera(p);
}

/** Full of corners between two columns. */
inline std::shared_ptr<const PreparedImage> texturedFrame(unsigned seed, double left_px = 0.0,
                                                          double right_px = kKeptWidth_px)
{
    const Texture texture(seed);
    const auto grey = [&](double u, double v)
    { return u >= left_px && u < right_px ? texture.at(u, v) : 128.0; };
    return prepareImage(renderImage(kKeptWidth_px, kKeptHeight_px, grey), 0.7);
}

/** Nothing can be detected or followed in it. */
inline std::shared_ptr<const PreparedImage> flatFrame()
{
    return prepareImage(cv::Mat(kKeptHeight_px, kKeptWidth_px, CV_8UC1, cv::Scalar(90)), 0.7);
}

inline Belief cameraAtOrigin()
{
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    return Belief::ofCamera(x_v, 1e-6 * Matrix13d::Identity());
}

/** A belief with one inverse-depth landmark almost straight ahead. */
inline Belief withLandmark(LandmarkId id, double rho, double sigma_rho,
                           Belief belief = cameraAtOrigin())
{
    const Vector6d y = (Vector6d() << 0, 0, 0, 0.1, 0.05, rho).finished();
    Eigen::MatrixXd P_yy = 1e-6 * Eigen::MatrixXd::Identity(6, 6);
    P_yy(5, 5) = sigma_rho * sigma_rho;
    const Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(6, belief.size());
    return append(std::move(belief), id, LandmarkKind::InverseDepth, y, P_yx, P_yy);
}

struct KeptMap
{
    explicit KeptMap(const MonoSlamOptions& options) : keeper(options, camera, 1) {}

    /** First landmarks in a textured image; their ids. */
    std::vector<LandmarkId> addFirst()
    {
        mixture = keeper.addFirst(std::move(mixture), {texturedFrame(1), frame}, 1.0, 0.5);
        return ids();
    }

    /** One frame in which nothing new can be found; all that was seen has the same fate. */
    void revise(const std::vector<LandmarkId>& seen, Fate fate)
    {
        std::vector<Association> associations;
        for (const LandmarkId id : seen)
        {
            Association association;
            association.id = id;
            association.fate = fate;
            associations.push_back(association);
        }
        revise(associations, flatFrame());
    }

    void revise(const std::vector<Association>& associations,
                std::shared_ptr<const PreparedImage> image)
    {
        Correction correction;
        correction.associations = associations;
        mixture = keeper.revise(std::move(mixture), correction, {std::move(image), ++frame});
        for (const auto& weighted : mixture) weighted.belief.checkInvariant();
    }

    [[nodiscard]] const Belief& belief() const { return best(mixture); }
    [[nodiscard]] bool holds(LandmarkId id) const
    {
        return belief().find(id) >= 0 && keeper.records().count(id) > 0;
    }
    [[nodiscard]] std::vector<LandmarkId> ids() const
    {
        std::vector<LandmarkId> all;
        for (const auto& slot : belief().landmarks) all.push_back(slot.id);
        return all;
    }

    Camera camera = keptCamera();
    MapKeeper keeper;
    Mixture mixture{{cameraAtOrigin(), 0.0}};
    long frame = 0;
};
}  // namespace monoslam
