// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>

#include "monoslam_eval/SyntheticWorld.h"

namespace monoslam::test
{
inline Vector13d atOrigin()
{
    Vector13d x_v = Vector13d::Zero();
    x_v[camera_state::kOrientation] = 1.0;
    return x_v;
}

/** Landmarks in a row, 2 m before the camera. */
inline SyntheticWorld rowOf(int count, const SyntheticWorldOptions& options, unsigned seed = 1)
{
    SyntheticWorld world(options, seed);
    for (int i = 0; i < count; ++i) world.addLandmark({0.1 * (i - 0.5 * count), 0.0, 2.0});
    return world;
}

inline SyntheticWorldOptions quiet()
{
    SyntheticWorldOptions options;
    options.sigma_px = 0.5;
    return options;
}

/** The feature that is the image of a landmark, or, of no landmark, that resembles it. */
inline std::optional<PixelFeature> find(const PixelFrame& frame, LandmarkId like, LandmarkId truth)
{
    for (const PixelFeature& feature : frame.features)
        if (feature.truth == truth && feature.resembles.at(0).landmark == like) return feature;
    return std::nullopt;
}

inline bool same(const PixelFrame& a, const PixelFrame& b)
{
    return a.t_s == b.t_s &&
           std::equal(a.features.begin(), a.features.end(), b.features.begin(), b.features.end(),
                      [](const PixelFeature& p, const PixelFeature& q)
                      {
                          return p.id == q.id && p.z == q.z && p.truth == q.truth &&
                                 p.resembles[0].score == q.resembles[0].score;
                      });
}
}  // namespace monoslam::test
