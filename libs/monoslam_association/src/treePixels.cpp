// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bestCandidates.h"
#include "monoslam_association/PixelGaussian.h"

namespace monoslam
{
namespace
{
struct Edge
{
    std::size_t to = 0;
    Eigen::Matrix2d cross;  ///< Cov(to, from)
};

class TreePixels : public PixelGaussian
{
   public:
    explicit TreePixels(const Prediction& prediction)
        : edges_(static_cast<std::size_t>(prediction.count()))
    {
        for (Eigen::Index i = 0; i < prediction.count(); ++i)
        {
            mean_.push_back(prediction.rows[static_cast<std::size_t>(i)].h);
            blocks_.emplace_back(symmetricBlock(prediction, i, i));
        }
        const auto parents = chowLiuParents(prediction);
        for (std::size_t i = 0; i < parents.size(); ++i)
        {
            if (parents[i] < 0) continue;
            const auto parent = static_cast<std::size_t>(parents[i]);
            const Eigen::Matrix2d cross =
                symmetricBlock(prediction, static_cast<Eigen::Index>(i), parents[i]);
            edges_[parent].push_back({i, cross});
            edges_[i].push_back({parent, cross.transpose()});
        }
    }

    [[nodiscard]] std::unique_ptr<PixelGaussian> clone() const override
    {
        return std::make_unique<TreePixels>(*this);
    }
    [[nodiscard]] Eigen::Vector2d mean(Eigen::Index row) const override
    {
        return mean_[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] Eigen::Matrix2d covariance(Eigen::Index row) const override
    {
        return blocks_[static_cast<std::size_t>(row)];
    }

    void condition(Eigen::Index row, const Eigen::Vector2d& z, const Eigen::Matrix2d& R) override
    {
        const auto measured = static_cast<std::size_t>(row);
        const Eigen::Matrix2d before = blocks_[measured];
        const Eigen::Matrix2d gain = before * (before + R).inverse();
        const Eigen::Vector2d shift = gain * (z - mean_[measured]);
        const Eigen::Matrix2d after = before - gain * before;
        settle(measured, shift, 0.5 * (after + after.transpose()));

        std::vector<std::pair<std::size_t, std::size_t>> toVisit;  // node and where it came from
        std::vector<std::pair<Eigen::Vector2d, Eigen::Matrix2d>> changes;
        toVisit.emplace_back(measured, measured);
        changes.emplace_back(shift, before);
        while (!toVisit.empty())
        {
            const auto [node, from] = toVisit.back();
            const auto [moved, old] = changes.back();
            toVisit.pop_back();
            changes.pop_back();
            for (Edge& edge : edges_[node])
            {
                if (edge.to == from) continue;
                const Eigen::Matrix2d prior = blocks_[edge.to];
                const Eigen::Matrix2d B = regression(edge.cross, old);
                const Eigen::Vector2d d = B * moved;
                settle(edge.to, d, prior + B * (blocks_[node] - old) * B.transpose());
                setCross(node, edge, B * blocks_[node]);
                toVisit.emplace_back(edge.to, node);
                changes.emplace_back(d, prior);
            }
        }
    }

   private:
    static Eigen::Matrix2d symmetricBlock(const Prediction& prediction, Eigen::Index i,
                                          Eigen::Index j)
    {
        return 0.5 * (prediction.HPHt.block<2, 2>(2 * i, 2 * j) +
                      prediction.HPHt.block<2, 2>(2 * j, 2 * i).transpose());
    }

    /** cross old^-1; nothing is passed on where the pixel had no variance. */
    static Eigen::Matrix2d regression(const Eigen::Matrix2d& cross, const Eigen::Matrix2d& old)
    {
        if (!positiveDefinite(old)) return Eigen::Matrix2d::Zero();
        return cross * old.inverse();
    }

    void settle(std::size_t i, const Eigen::Vector2d& shift, const Eigen::Matrix2d& covariance)
    {
        mean_[i] += shift;
        blocks_[i] = 0.5 * (covariance + covariance.transpose());
    }

    void setCross(std::size_t node, Edge& edge, const Eigen::Matrix2d& cross)
    {
        edge.cross = cross;
        for (Edge& back : edges_[edge.to])
            if (back.to == node) back.cross = cross.transpose();
    }

    std::vector<Eigen::Vector2d> mean_;
    std::vector<Eigen::Matrix2d> blocks_;
    std::vector<std::vector<Edge>> edges_;
};

double pairInformation(const Prediction& prediction, Eigen::Index i, Eigen::Index j)
{
    const Eigen::Matrix2d& S_i = prediction.rows[static_cast<std::size_t>(i)].S;
    const Eigen::Matrix2d& S_j = prediction.rows[static_cast<std::size_t>(j)].S;
    if (!positiveDefinite(S_i)) return 0.0;
    const Eigen::Matrix2d cross = prediction.HPHt.block<2, 2>(2 * i, 2 * j);
    const Eigen::Matrix2d given = S_j - cross.transpose() * S_i.inverse() * cross;
    const double ratio = S_j.determinant() / given.determinant();
    return ratio > 1.0 && std::isfinite(ratio) ? 0.5 * std::log2(ratio) : 0.0;
}
}  // namespace

std::vector<Eigen::Index> chowLiuParents(const Prediction& prediction)
{
    const auto m = static_cast<std::size_t>(prediction.count());
    std::vector<Eigen::Index> parents(m, -1);
    std::vector<double> best(m, 0.0);
    std::vector<std::size_t> left(m);  // by landmark, so that the order of the rows breaks no tie
    std::iota(left.begin(), left.end(), 0);
    std::sort(left.begin(), left.end(),
              [&](std::size_t a, std::size_t b)
              { return prediction.rows[a].id < prediction.rows[b].id; });
    while (!left.empty())
    {
        const auto next =
            std::max_element(left.begin(), left.end(),
                             [&](std::size_t a, std::size_t b) { return best[a] < best[b]; });
        const auto added = static_cast<Eigen::Index>(*next);
        left.erase(next);
        for (const std::size_t i : left)
        {
            const double bits = pairInformation(prediction, added, static_cast<Eigen::Index>(i));
            if (bits <= best[i]) continue;
            best[i] = bits;
            parents[i] = added;
        }
    }
    return parents;
}

std::unique_ptr<PixelGaussian> treePixels(const Prediction& prediction)
{
    return std::make_unique<TreePixels>(prediction);
}
}  // namespace monoslam
