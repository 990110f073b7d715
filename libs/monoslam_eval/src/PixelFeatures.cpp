// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/PixelFeatures.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace monoslam
{
namespace
{
using Gallery = std::map<LandmarkId, std::vector<Candidate>>;

/** Candidates of every landmark, best scores first; of equal ones the feature that comes first. */
Gallery galleryOf(const PixelFrame& frame)
{
    Gallery gallery;
    for (const PixelFeature& feature : frame.features)
        for (const Resemblance& like : feature.resembles)
            gallery[like.landmark].push_back({feature.z, like.score, feature.R});
    for (auto& [id, candidates] : gallery)
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    return gallery;
}

SearchResult search(const Gallery& gallery, const SearchRegion& region)
{
    SearchResult result;
    result.pixels = std::lround(M_PI * region.gate * std::sqrt(region.S.determinant()));
    const auto entry = gallery.find(region.id);
    if (entry == gallery.end()) return result;
    const auto most = static_cast<std::size_t>(std::max(1, region.maxCandidates));
    const Eigen::Matrix2d precision = region.S.inverse();
    for (const Candidate& candidate : entry->second)
    {
        const Eigen::Vector2d nu = candidate.z - region.centre;
        const bool scores = !region.minScore || candidate.score >= *region.minScore;
        if (scores && nu.dot(precision * nu) < region.gate && result.candidates.size() < most)
            result.candidates.push_back(candidate);
    }
    return result;
}
}  // namespace

FrameView viewOf(const PixelFrame& frame, const Camera& camera, const VisibilityOptions& visibility)
{
    const auto gallery = std::make_shared<const Gallery>(galleryOf(frame));
    FrameView view;
    view.predict = [&camera, visibility](const Belief& belief)
    { return predictMeasurements(belief, camera, visibility); };
    view.linearize = [&camera, visibility](const Eigen::VectorXd& x, const LandmarkSlot& slot)
    { return linearizeLandmark(x, slot, camera, visibility); };
    view.search = [gallery](const SearchRegion& region) { return search(*gallery, region); };
    view.imageArea_px2 = 1.0 * camera.parameters().width_px * camera.parameters().height_px;
    return view;
}
}  // namespace monoslam
