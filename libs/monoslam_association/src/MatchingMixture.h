// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "matchActively.h"

namespace monoslam
{
/** The ellipse to search next. */
struct MatchingTarget
{
    Eigen::Index row = 0;
    Eigen::Vector2d centre;  ///< [px]
    Eigen::Matrix2d S;       ///< with R and what linearisation misses [px^2]
    double gate = 0.0;
    double bits = 0.0;              ///< Mc + Md
    std::vector<double> mass = {};  ///< q_j of every Gaussian
};

/** The mixture of Active Matching, see matchActively(). */
class MatchingMixture
{
   public:
    struct Settings
    {
        MatchingOptions options;
        double imageArea_px2 = 640.0 * 480.0;
    };
    struct Component
    {
        double weight = 1.0;
        std::unique_ptr<PixelGaussian> pixels;
        std::vector<bool> open;                        ///< rows that may still be measured
        std::vector<std::optional<Candidate>> chosen;  ///< pixel of each row, if it has one
    };

    /** \param prediction  must outlive this object */
    MatchingMixture(std::unique_ptr<PixelGaussian> prior, const Prediction& prediction,
                    const std::vector<Eigen::Index>& rows, const Settings& settings);

    /** The pair of Gaussian and row of most information per area; nothing tells enough: none. */
    [[nodiscard]] std::optional<MatchingTarget> mostEfficient() const;
    void split(const MatchingTarget& target, const std::vector<Candidate>& found);
    /** The row cannot be searched. */
    void giveUp(Eigen::Index row);

    [[nodiscard]] bool heaviestIsOpen() const;
    /** After split() the first. */
    [[nodiscard]] const Component& heaviest() const { return components_.front(); }
    [[nodiscard]] std::size_t size() const { return components_.size(); }

   private:
    struct Child
    {
        double weight = 0.0;
        std::size_t parent = 0;
        const Candidate* found = nullptr;  ///< nothing: not found
        bool touched = true;               ///< false: the ellipse says nothing about the parent
    };

    [[nodiscard]] Eigen::Matrix2d searchedS(const Component& component, Eigen::Index row) const;
    [[nodiscard]] double continuousBits(const Component& component, Eigen::Index row) const;
    [[nodiscard]] double discreteBits(const std::vector<double>& mass) const;
    [[nodiscard]] MatchingTarget targetOf(std::size_t k, Eigen::Index row) const;
    [[nodiscard]] std::vector<Child> childrenOf(const MatchingTarget& target,
                                                const std::vector<Candidate>& found) const;
    void prune(std::vector<Child>& children) const;
    [[nodiscard]] Component grow(const Child& child, bool lastOfItsParent,
                                 const MatchingTarget& target);

    const Prediction& prediction_;
    std::vector<Eigen::Index> rows_;
    MatchingOptions options_;
    double gate_;
    double P_D_;
    double logBeta_;
    std::vector<Component> components_;
};
}  // namespace monoslam
