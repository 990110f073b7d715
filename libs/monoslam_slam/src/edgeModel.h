// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace monoslam
{
/** A pixel near one side of a quadrilateral. */
struct EdgePixel
{
    double d_px;     ///< signed distance from the side's first guess, > 0 outside
    double s;        ///< along the side, -1 .. 1
    double stretch;  ///< this pixel's pixels per unit of the side's offset (1 without distortion)
    double grey;     ///< 0 .. 255
};

/** A blurred step edge: grey = response(dark + (bright - dark) Phi((d - offset - tilt s) / blur)).
 *
 * Light is mixed by the lens before the sensor encodes it, so a contrasty edge is symmetric in
 * light, not in grey levels: its apparent middle moves into the dark side by up to half a pixel.
 * The response is therefore part of the fit. */
struct SideFit
{
    double offset_px = 0.0;  ///< the line's correction at the middle of the side
    double tilt_px = 0.0;    ///< the same, difference between the end and the middle
    double inside = 0.0;     ///< grey levels / 255
    double outside = 0.0;
    double shading = 0.0;  ///< change of `outside` from the middle to the end of the side
    double blur_px = 1.0;
};

struct EdgeFit
{
    std::array<SideFit, 4> sides;
    double response = 0.5;    ///< 0: grey is proportional to light, 1: sRGB; in between, mixed
    double noise_grey = 0.0;  ///< robust std of the residuals
    int steps = 0;            ///< Gauss-Newton steps taken, 20 at most
};

/** Fits the four sides jointly, by robust Gauss-Newton steps from grey-level quantiles.
 *  \param before an earlier fit of the same sides, placed anew since: where to begin, or null
 *  \param tolerance of the last step, [px] and grey levels / 255
 *  \return nothing if it diverges or a side has too few pixels */
[[nodiscard]] std::optional<EdgeFit> fitEdges(const std::array<std::vector<EdgePixel>, 4>& sides,
                                              const EdgeFit* before, double tolerance);
}  // namespace monoslam
