// SPDX-License-Identifier: BSD-3-Clause
#include "MatchingMixture.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ConditionalPrediction.h"
#include "bestCandidates.h"
#include "monoslam_association/ellipseMass.h"
#include "monoslam_association/informationGain.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
/** -x log2 x of a weight that is not normalised: entropies of sums follow from it. */
double plog(double x)
{
    return x > 0.0 ? -x * std::log2(x) : 0.0;
}
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

double MatchingMixture::continuousBits(const Component& component, Eigen::Index row) const
{
    const Eigen::Matrix2d& R = prediction_.rows[static_cast<std::size_t>(row)].R;
    const Eigen::Matrix2d S = component.pixels->covariance(row) + R;
    return component.weight * P_D_ * std::max(0.0, informationAboutState(S, R));
}

/** What finding or not finding is expected to tell about which Gaussian is right. */
double MatchingMixture::discreteBits(const std::vector<double>& mass) const
{
    double found = 0.0, before = 0.0, ifFound = 0.0, ifNot = 0.0;
    for (std::size_t j = 0; j < mass.size(); ++j)
    {
        const double weight = components_[j].weight;
        const double hit = weight * P_D_ * mass[j];
        found += hit;
        before += plog(weight);
        ifFound += plog(hit);
        ifNot += plog(weight - hit);
    }
    // p H(x / p) = sum -x log x + p log p
    return before - (ifFound - plog(found)) - (ifNot - plog(1.0 - found));
}

MatchingTarget MatchingMixture::targetOf(std::size_t k, Eigen::Index row) const
{
    const Component& component = components_[k];
    MatchingTarget target;
    target.row = row;
    target.centre = component.pixels->mean(row);
    target.S = searchedS(component, row);
    target.gate = gate_;
    for (std::size_t j = 0; j < components_.size(); ++j)
    {
        const Component& other = components_[j];
        double mass = 0.0;
        if (j == k)
            mass = options_.clutter.p_search;
        else if (other.open[static_cast<std::size_t>(row)])
            mass = ellipseMass(other.pixels->mean(row) - target.centre, searchedS(other, row),
                               target.S, gate_);
        target.mass.push_back(mass);
    }
    const double discrete = components_.size() > 1 ? discreteBits(target.mass) : 0.0;
    target.bits = continuousBits(component, row) + discrete;
    return target;
}

std::optional<MatchingTarget> MatchingMixture::mostEfficient() const
{
    double entropy = 0.0;
    for (const Component& component : components_) entropy += plog(component.weight);
    struct Entry
    {
        double bound;  ///< of bits per area: Md <= H(lam)
        std::size_t k;
        Eigen::Index row;
        double area_px2;
    };
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < components_.size(); ++k)
        for (const Eigen::Index row : rows_)
        {
            if (!components_[k].open[static_cast<std::size_t>(row)]) continue;
            const Eigen::Matrix2d S = searchedS(components_[k], row);
            if (!positiveDefinite(S) || !components_[k].pixels->mean(row).allFinite()) continue;
            const double area_px2 = M_PI * gate_ * std::sqrt(S.determinant());
            const double bits = continuousBits(components_[k], row) + entropy;
            if (bits >= options_.stop_bits) entries.push_back({bits / area_px2, k, row, area_px2});
        }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.bound > b.bound; });
    std::optional<MatchingTarget> best;
    double most = 0.0;
    for (const Entry& entry : entries)
    {
        if (best && entry.bound <= most) break;
        MatchingTarget target = targetOf(entry.k, entry.row);
        if (target.bits < options_.stop_bits || target.bits / entry.area_px2 <= most) continue;
        most = target.bits / entry.area_px2;
        best = std::move(target);
    }
    return best;
}

std::vector<MatchingMixture::Child> MatchingMixture::childrenOf(
    const MatchingTarget& target, const std::vector<Candidate>& found) const
{
    std::vector<Child> children;
    for (std::size_t j = 0; j < components_.size(); ++j)
    {
        const Component& parent = components_[j];
        if (target.mass[j] <= options_.prune)
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
