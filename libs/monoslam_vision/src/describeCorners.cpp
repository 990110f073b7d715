// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/describeCorners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
constexpr std::array<double, 3> kScales{1.0, 0.7071067811865476, 0.5};
constexpr int kMostCorners = 800;  ///< of the image; of a smaller scale in proportion to its sides
constexpr double kQuality = 0.01;  ///< of a corner over the strongest one's
constexpr double kDistance_px = 4.0;
constexpr int kHalf_px = 15;         ///< of what an orientation is seen by
constexpr int kBorder_px = 20;       ///< a descriptor reaches this far
constexpr int kCrop_px = 64;         ///< around a place: all that its descriptors need
constexpr int kLikest = 6;           ///< of the rows seen: some belong to the same corner
constexpr double kSamePlace_px = 8;  ///< rows of two scales of one corner
constexpr float kMostBits = 70.0F;   ///< of 256 in which descriptors of one place differ
constexpr float kClearly = 0.9F;     ///< of the bits to the next corner

/** Angle from a corner to the centre of the light around it [deg]. */
float orientation_deg(const cv::Mat& image, const cv::Point2f& at)
{
    static const cv::Mat disc = []
    {
        cv::Mat mask = cv::Mat::zeros(2 * kHalf_px + 1, 2 * kHalf_px + 1, CV_8U);
        cv::circle(mask, {kHalf_px, kHalf_px}, kHalf_px, cv::Scalar(255), cv::FILLED);
        return mask;
    }();
    const cv::Point corner(cvRound(at.x) - kHalf_px, cvRound(at.y) - kHalf_px);
    cv::Mat around;
    image(cv::Rect(corner, disc.size())).copyTo(around, disc);
    const cv::Moments m = cv::moments(around);
    return cv::fastAtan2(static_cast<float>(m.m01 - kHalf_px * m.m00),
                         static_cast<float>(m.m10 - kHalf_px * m.m00));
}

cv::Mat scaled(const cv::Mat& image, double scale)
{
    if (scale == 1.0) return image;
    cv::Mat smaller;
    cv::resize(image, smaller, {}, scale, scale, cv::INTER_AREA);
    return smaller;
}

/** Where a pixel of the image is in the scaled one: integer coordinates are at the pixels' centres. */
double scaledPixel(double u, double scale)
{
    return scale * (u + 0.5) - 0.5;
}

/** Describes some pixels of an image of one scale; origin is where it begins in the image itself. */
void append(const cv::Mat& image, const std::vector<cv::Point2f>& pixels, double scale,
            const std::vector<std::size_t>& indices, const Eigen::Vector2d& origin,
            DescribedCorners& all)
{
    const cv::Ptr<cv::ORB> orb = cv::ORB::create(kMostCorners, 1.2F, 1, kBorder_px);
    const cv::Rect inner(kBorder_px, kBorder_px, image.cols - 2 * kBorder_px,
                         image.rows - 2 * kBorder_px);
    std::vector<cv::KeyPoint> places;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (inner.contains(cv::Point(cvRound(pixels[i].x), cvRound(pixels[i].y))))
            places.emplace_back(pixels[i], 2.0F * kHalf_px + 1.0F,
                                orientation_deg(image, pixels[i]), 0.0F, 0, static_cast<int>(i));
    if (places.empty()) return;
    cv::Mat descriptors;
    orb->compute(image, places, descriptors);
    for (const cv::KeyPoint& place : places)
    {
        all.uv_px.push_back(origin + Eigen::Vector2d(scaledPixel(place.pt.x, 1.0 / scale),
                                                     scaledPixel(place.pt.y, 1.0 / scale)));
        all.index.push_back(indices[static_cast<std::size_t>(place.class_id)]);
    }
    all.descriptors.push_back(descriptors);
}
}  // namespace

DescribedCorners describeImage(const PreparedImage& image)
{
    DescribedCorners all;
    std::size_t places = 0;
    for (const double scale : kScales)
    {
        const cv::Mat smaller = scaled(image.levels.front(), scale);
        if (std::min(smaller.cols, smaller.rows) <= 2 * kBorder_px) break;
        std::vector<cv::Point2f> corners;
        cv::goodFeaturesToTrack(smaller, corners, cvRound(kMostCorners * scale), kQuality,
                                kDistance_px);
        std::vector<std::size_t> indices(corners.size());
        std::iota(indices.begin(), indices.end(), places);
        places += corners.size();
        append(smaller, corners, scale, indices, Eigen::Vector2d::Zero(), all);
    }
    return all;
}

void describePlace(const PreparedImage& image, const Eigen::Vector2d& uv_px, std::size_t index,
                   DescribedCorners& all)
{
    const cv::Mat& whole = image.levels.front();
    const cv::Point centre(cvRound(uv_px.x()), cvRound(uv_px.y()));
    const cv::Rect box =
        cv::Rect(centre.x - kCrop_px, centre.y - kCrop_px, 2 * kCrop_px + 1, 2 * kCrop_px + 1) &
        cv::Rect(0, 0, whole.cols, whole.rows);
    const Eigen::Vector2d origin(box.x, box.y);
    for (const double scale : kScales)
    {
        const cv::Mat smaller = scaled(whole(box), scale);
        const cv::Point2f at(static_cast<float>(scaledPixel(uv_px.x() - origin.x(), scale)),
                             static_cast<float>(scaledPixel(uv_px.y() - origin.y(), scale)));
        append(smaller, {at}, scale, {index}, origin, all);
    }
}

std::vector<CornerMatch> matchCorners(const DescribedCorners& known, const DescribedCorners& seen)
{
    if (known.uv_px.empty() || seen.uv_px.empty()) return {};
    std::vector<std::vector<cv::DMatch>> likest;
    cv::BFMatcher(cv::NORM_HAMMING).knnMatch(known.descriptors, seen.descriptors, likest, kLikest);
    std::map<std::size_t, std::vector<cv::DMatch>> ofPlace;
    for (std::size_t row = 0; row < likest.size(); ++row)
    {
        auto& all = ofPlace[known.index[row]];
        all.insert(all.end(), likest[row].begin(), likest[row].end());
    }
    std::vector<CornerMatch> matches;
    for (auto& [index, all] : ofPlace)
    {
        std::stable_sort(all.begin(), all.end());
        const cv::DMatch& first = all.front();
        const Eigen::Vector2d& uv_px = seen.uv_px[static_cast<std::size_t>(first.trainIdx)];
        const auto another = std::find_if(
            all.begin(), all.end(),
            [&](const cv::DMatch& m) {
                return (seen.uv_px[static_cast<std::size_t>(m.trainIdx)] - uv_px).norm() >
                       kSamePlace_px;
            });
        if (first.distance > kMostBits) continue;
        if (another != all.end() && first.distance > kClearly * another->distance) continue;
        matches.push_back({index, uv_px});
    }
    return matches;
}
}  // namespace monoslam
