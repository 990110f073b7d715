// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/detectCorners.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "monoslam_vision/Patch.h"
#include "monoslam_vision/searchPatch.h"

namespace monoslam
{
namespace
{
constexpr int kBlock = 5;
constexpr int kSobel = 3;
constexpr int kOwnPeak_px = 3;

struct Cell
{
    cv::Rect box;
    int count = 0;
    cv::Mat response;  ///< once it has been asked for
};

std::vector<Cell> makeGrid(const PreparedImage& image, const std::vector<Eigen::Vector2d>& taken,
                           const DetectionOptions& options)
{
    std::vector<Cell> cells;
    const int border = static_cast<int>(options.border_px);
    const cv::Rect inner(border, border, image.width_px - 2 * border, image.height_px - 2 * border);
    for (int row = 0; row < options.gridRows; ++row)
        for (int column = 0; column < options.gridColumns; ++column)
        {
            const int left = image.width_px * column / options.gridColumns;
            const int top = image.height_px * row / options.gridRows;
            const int right = image.width_px * (column + 1) / options.gridColumns;
            const int bottom = image.height_px * (row + 1) / options.gridRows;
            Cell cell{cv::Rect(left, top, right - left, bottom - top), 0, {}};
            for (const auto& pixel : taken)
                if (cell.box.contains(
                        cv::Point(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()))))
                    ++cell.count;
            cell.box &= inner;
            cells.push_back(cell);
        }
    return cells;
}

void clearAround(Cell& cell, const Eigen::Vector2d& pixel, double distance_px)
{
    if (cell.response.empty()) return;
    cv::circle(cell.response,
               cv::Point(static_cast<int>(std::lround(pixel.x())) - cell.box.x,
                         static_cast<int>(std::lround(pixel.y())) - cell.box.y),
               static_cast<int>(distance_px), cv::Scalar(0), cv::FILLED);
}

/** Smaller eigenvalues in one cell; pixels near a taken one are cleared. */
void respond(const PreparedImage& image, Cell& cell, const std::vector<Eigen::Vector2d>& taken,
             double distance_px)
{
    if (!cell.response.empty()) return;
    cv::cornerMinEigenVal(image.levels.front()(cell.box), cell.response, kBlock, kSobel);
    for (const auto& pixel : taken) clearAround(cell, pixel, distance_px);
}

/** True if the corner's patch is found again near by: it would be mistaken for itself. */
bool resemblesSurroundings(const PreparedImage& image, const Eigen::Vector2d& uv,
                           const DetectionOptions& options)
{
    if (options.maxSelfSimilarity >= 1.0) return false;
    Appearance self;
    self.image = std::shared_ptr<const PreparedImage>(&image, [](const PreparedImage*) {});
    self.uv_px = uv;
    const auto patch = samplePatch(self, PredictedWarp{}, options.half_px);
    if (!patch) return true;
    PatchSearchRegion region;
    region.centre_px = uv;
    region.S = Eigen::Matrix2d::Identity();
    region.gate = options.similarityRadius_px * options.similarityRadius_px;
    region.minScore = options.maxSelfSimilarity;
    region.maxPeaks = 2;
    region.peakDistance_px = kOwnPeak_px;
    return searchPatch(image, *patch, region).peaks.size() > 1;
}

std::vector<std::size_t> emptiestFirst(const std::vector<Cell>& cells, std::mt19937& rng)
{
    std::vector<std::size_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), rng);
    std::stable_sort(order.begin(), order.end(),
                     [&cells](std::size_t a, std::size_t b)
                     { return cells[a].count < cells[b].count; });
    return order;
}
}  // namespace

std::vector<Corner> detectCorners(const PreparedImage& image,
                                  const std::vector<Eigen::Vector2d>& taken, int wanted,
                                  const DetectionOptions& options, double& strongest,
                                  std::mt19937& rng)
{
    std::vector<Corner> corners;
    std::vector<Eigen::Vector2d> occupied = taken;
    std::vector<Cell> cells = makeGrid(image, taken, options);
    int budget = taken.empty() ? std::numeric_limits<int>::max() : options.maxCells;
    for (int round = 0; round < options.maxPerCell; ++round)
        for (const std::size_t index : emptiestFirst(cells, rng))
        {
            if (static_cast<int>(corners.size()) >= wanted) return corners;
            Cell& cell = cells[index];
            if (budget <= 0) return corners;
            if (cell.count > round || cell.box.width < kBlock || cell.box.height < kBlock) continue;
            --budget;
            respond(image, cell, occupied, options.minDistance_px);
            double best = 0.0;
            cv::Point at;
            cv::minMaxLoc(cell.response, nullptr, &best, nullptr, &at);
            strongest = std::max(strongest, best);
            if (best < std::max(options.quality * strongest, options.minResponse))
            {
                cell.count = options.maxPerCell;
                continue;
            }
            const Eigen::Vector2d uv(at.x + cell.box.x, at.y + cell.box.y);
            ++cell.count;
            occupied.push_back(uv);
            for (Cell& other : cells) clearAround(other, uv, options.minDistance_px);
            if (resemblesSurroundings(image, uv, options)) continue;
            corners.push_back({uv, best});
        }
    return corners;
}
}  // namespace monoslam
