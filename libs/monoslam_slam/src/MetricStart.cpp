// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MetricStart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "findTarget.h"
#include "monoslam_models/quaternion.h"
#include "planarPose.h"
#include "rectangleEvidence.h"

namespace monoslam
{
namespace
{
constexpr double kContourSigma_px = 1.5;
constexpr std::size_t kMostRefined = 20;
constexpr double kRival = 0.5;  ///< of the best evidence: less is no rival

/** The quad labelled as the world's rectangle, starting at its corner k. */
SeenPoints labelled(const Quad& quad, int k, double sigma_px, const MetricStartOptions& options)
{
    const double x_m = 0.5 * options.rectangle_size_m.x();
    const double y_m = 0.5 * options.rectangle_size_m.y();
    SeenPoints seen;
    seen.points_m = {{-x_m, -y_m, 0}, {x_m, -y_m, 0}, {x_m, y_m, 0}, {-x_m, y_m, 0}};
    for (int i = 0; i < 4; ++i) seen.pixels_px.push_back(quad[(i + k) % 4]);
    seen.sigmas_px.assign(4, sigma_px);
    seen.point_sigma_m = options.point_sigma_m;
    return seen;
}

double alignment(const MetricPose& pose)
{
    return rotationMatrix(pose.pose.tail<4>())(0, 0);
}

/** Keeps the better aligned of two labellings that the rectangle's symmetry makes equal. */
void keepAligned(MetricStartResult& best, MetricStartResult other)
{
    if (best.found && other.found && alignment(*other.found) > alignment(*best.found))
        best = std::move(other);
}

MetricStartResult poseOfRectangle(const Quad& quad, const Camera& camera,
                                  const MetricStartOptions& options)
{
    const double sigma_px = options.corner_sigma_px;
    std::array<std::vector<PlanarSolution>, 2> solutions;
    for (int k = 0; k < 2; ++k)
        solutions[k] = solvePlanarPose(labelled(quad, k, sigma_px, options), camera);
    const Eigen::Vector2d& size_m = options.rectangle_size_m;
    const bool square = std::abs(size_m.x() - size_m.y()) < 1e-3 * size_m.maxCoeff();
    const auto chi2 = [&](int k) { return solutions[k].empty() ? 1e12 : solutions[k][0].chi2; };
    const int k = chi2(0) <= chi2(1) ? 0 : 1;
    MetricStartResult result = unambiguousPose(solutions[k]);
    if (result.found && !square && chi2(1 - k) < chi2(k) + kAmbiguousChi2)
        return {std::nullopt, "it is not clear which side of the rectangle is the longer one"};
    const auto partner = [&](int turn) {
        return unambiguousPose(
            solvePlanarPose(labelled(quad, k + turn, sigma_px, options), camera));
    };
    keepAligned(result, partner(2));
    if (square) keepAligned(result, partner(1));
    if (square) keepAligned(result, partner(3));
    return result;
}

/** Whether the rough corners can be a view of the rectangle at all: spares most refinements. */
bool plausible(const Quad& quad, const Camera& camera, const MetricStartOptions& options)
{
    for (int k = 0; k < 2; ++k)
    {
        const auto solutions =
            solvePlanarPose(labelled(quad, k, kContourSigma_px, options), camera);
        if (!solutions.empty() && solutions[0].chi2 < kFittingChi2) return true;
    }
    return false;
}

/** Two thresholds may find the same rectangle with different rough corners. */
bool sameAs(const std::optional<MetricPose>& pose, const Quad& quad)
{
    if (!pose) return false;
    Eigen::Vector2d between_px = -0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
    for (const auto& p : pose->pixels_px) between_px += 0.25 * p;
    return between_px.norm() < 2.0;
}

/** Pose from the filled dark quadrilateral of the strongest edges that is a view of the known
 *  rectangle. Small ones always are, more or less: a tile in perspective has any shape.
 *
 * Which side is the longer one is decided by the reprojection error. The half turn that remains
 * (and, for a square, the quarter turns) is decided by convention: the camera is above the plane,
 * z > 0, and its x axis is as near as possible to the world's. */
MetricStartResult findRectangle(const cv::Mat& image, const Camera& camera,
                                const MetricStartOptions& options)
{
    MetricStartResult best;
    best.reason = "no dark rectangle of that shape in the image";
    std::vector<double> evidence;
    double strongest = 0.0;
    std::size_t tried = 0;
    for (const auto& quad : findDarkQuads(image, camera))
    {
        // The largest come first: no contrast makes up for sides that are too short.
        if (tried == kMostRefined || perimeterOf(quad) < strongest) break;
        if (!roughlyDark(image, quad) || !plausible(quad, camera, options)) continue;
        const auto edges = refineEdgeQuad(image, camera, quad);
        const double strength = edges ? evidenceOfRectangle(image, *edges) : 0.0;
        if (!(strength > 0.0)) continue;
        if (sameAs(best.found, edges->corners_px)) continue;
        MetricStartResult result = poseOfRectangle(edges->corners_px, camera, options);
        if (result.found)
            evidence.push_back(strength);
        else if (tried++ == 0 && !best.found)
            best.reason = "largest dark quadrilateral: " + result.reason;
        if (!result.found || strength <= strongest) continue;
        strongest = strength;
        best = std::move(result);
    }
    const auto rivals = std::count_if(evidence.begin(), evidence.end(),
                                      [&](double e) { return e >= kRival * strongest; });
    if (rivals > 1)
        best.reason =
            std::to_string(rivals) + " rectangles fit; the one of strongest edges was taken";
    return best;
}
MetricStartResult poseOf(const TargetSearch& search, const Camera& camera)
{
    if (!search.seen) return {std::nullopt, search.note};
    MetricStartResult result = unambiguousPose(solvePlanarPose(*search.seen, camera));
    result.reason = search.note + result.reason;
    return result;
}
}  // namespace

MetricStartResult metricPoseFrom(const std::vector<Eigen::Vector2d>& pixels_px,
                                 const Camera& camera, const MetricStartOptions& options)
{
    if (pixels_px.size() != options.target_points_m.size() || pixels_px.size() < 4)
        throw std::invalid_argument(
            "metric start: as many pixels as points are needed, at least 4");
    return unambiguousPose(solvePlanarPose(
        {options.target_points_m, pixels_px,
         std::vector<double>(pixels_px.size(), options.corner_sigma_px), options.point_sigma_m},
        camera));
}

MetricStartResult findMetricPose(const cv::Mat& image, const Camera& camera,
                                 const MetricStartOptions& options)
{
    const CameraParameters& p = camera.parameters();
    if (image.type() != CV_8UC1 || image.cols != p.width_px || image.rows != p.height_px)
        throw std::invalid_argument(
            "metric start: the image is not 8-bit grey of the camera's size");
    switch (options.method)
    {
        case MetricStartMethod::TargetPoints:
            return poseOf(refineTargetPoints(image, camera, options), camera);
        case MetricStartMethod::Rectangle:
            return findRectangle(image, camera, options);
        case MetricStartMethod::Chessboard:
            return poseOf(findChessboard(image, options), camera);
        case MetricStartMethod::None:
            break;
    }
    return {std::nullopt, "no metric target is configured"};
}
}  // namespace monoslam
