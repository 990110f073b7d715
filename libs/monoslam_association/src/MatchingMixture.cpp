// SPDX-License-Identifier: BSD-3-Clause
#include "MatchingMixture.h"

#include <algorithm>
#include <cmath>

#include "ConditionalPrediction.h"
#include "bestCandidates.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
/** Share of the mass in a Gaussian's own ellipse that another ellipse must hold to search for it. */
constexpr double kCovered = 0.5;
}  // namespace

MatchingMixture::MatchingMixture(std::unique_ptr<PixelGaussian> prior, const Prediction& prediction,
                                 const std::vector<Eigen::Index>& rows, const Settings& settings)
    : prediction_(prediction),
      rows_(rows),
      options_(settings.options),
      gate_(chi2Limit(2, settings.options.clutter.p_search)),
      P_D_(settings.options.clutter.p_present * settings.options.clutter.p_search),
      logBeta_(std::log(settings.options.clutter.clutter_per_image / settings.imageArea_px2))
{
    Component& only = components_.emplace_back();
    only.pixels = std::move(prior);
    only.open.resize(prediction.rows.size(), false);
    only.chosen.resize(prediction.rows.size());
    for (const Eigen::Index row : rows_)
        only.open[static_cast<std::size_t>(row)] =
            prediction.rows[static_cast<std::size_t>(row)].h.allFinite() &&
            positiveDefinite(searchedS(only, row));
}

Eigen::Matrix2d MatchingMixture::searchedS(const Component& component, Eigen::Index row) const
{
    return component.pixels->covariance(row) + prediction_.rows[static_cast<std::size_t>(row)].R +
           kLinearizationVariance_px2 * Eigen::Matrix2d::Identity();
}

std::vector<MatchingMixture::Child> MatchingMixture::childrenOf(
    const MatchingTarget& target, const std::vector<Candidate>& found) const
{
    std::vector<Child> children;
    for (std::size_t j = 0; j < components_.size(); ++j)
    {
        const Component& parent = components_[j];
        if (target.mass[j] < kCovered * options_.clutter.p_search)
        {
            children.push_back({parent.weight, j, nullptr, false});
            continue;
        }
        children.push_back({parent.weight * (1.0 - P_D_ * target.mass[j]), j, nullptr, true});
        const Eigen::Matrix2d& R = prediction_.rows[static_cast<std::size_t>(target.row)].R;
        for (const Candidate& candidate : found)
        {
            const Eigen::Matrix2d S = searchedS(parent, target.row) - R + candidate.R;
            const Eigen::Vector2d nu = candidate.z - parent.pixels->mean(target.row);
            const double log = CandidateLikelihood::logDensity(nu, S) - logBeta_;
            children.push_back(
                {parent.weight * options_.clutter.p_present * std::exp(log), j, &candidate, true});
        }
    }
    return children;
}

/** Heaviest first, normalised, light ones dropped; a tie goes to what was found. */
void MatchingMixture::prune(std::vector<Child>& children) const
{
    std::stable_sort(children.begin(), children.end(),
                     [](const Child& a, const Child& b) { return a.weight > b.weight; });
    const double least = options_.prune * children.front().weight;
    const auto light = std::find_if(children.begin() + 1, children.end(),
                                    [least](const Child& child) { return child.weight < least; });
    children.erase(light, children.end());
    const auto most = static_cast<std::size_t>(options_.max_gaussians);
    if (children.size() > most) children.resize(most);
    double sum = 0.0;
    for (const Child& child : children) sum += child.weight;
    for (Child& child : children) child.weight /= sum;
}

MatchingMixture::Component MatchingMixture::grow(const Child& child, bool lastOfItsParent,
                                                 const MatchingTarget& target)
{
    Component& parent = components_[child.parent];
    Component grown;
    if (lastOfItsParent)
        grown = std::move(parent);
    else
    {
        grown.pixels = parent.pixels->clone();
        grown.open = parent.open;
        grown.chosen = parent.chosen;
    }
    grown.weight = child.weight;
    const auto row = static_cast<std::size_t>(target.row);
    if (child.touched) grown.open[row] = false;
    if (child.found != nullptr)
    {
        grown.chosen[row] = *child.found;
        if (positiveDefinite(grown.pixels->covariance(target.row) + child.found->R))
            grown.pixels->condition(target.row, child.found->z, child.found->R);
    }
    return grown;
}

void MatchingMixture::split(const MatchingTarget& target, const std::vector<Candidate>& found)
{
    std::vector<Child> children = childrenOf(target, found);
    prune(children);
    std::vector<std::size_t> left(components_.size(), 0);
    for (const Child& child : children) ++left[child.parent];
    std::vector<Component> next;
    for (const Child& child : children)
        next.push_back(grow(child, --left[child.parent] == 0, target));
    components_ = std::move(next);
}

void MatchingMixture::giveUp(Eigen::Index row)
{
    for (Component& component : components_) component.open[static_cast<std::size_t>(row)] = false;
}

bool MatchingMixture::heaviestIsOpen() const
{
    const std::vector<bool>& open = heaviest().open;
    return std::any_of(open.begin(), open.end(), [](bool isOpen) { return isOpen; });
}
}  // namespace monoslam
