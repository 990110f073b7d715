// SPDX-License-Identifier: BSD-3-Clause
// Which ellipse Active Matching searches next: expected information per area.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "MatchingMixture.h"
#include "bestCandidates.h"
#include "monoslam_association/ellipseMass.h"
#include "monoslam_association/informationGain.h"

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
}  // namespace monoslam
