// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/maximumClique.h"

#include <algorithm>

namespace monoslam
{
namespace
{
using Vertices = std::vector<std::size_t>;

class BronKerbosch
{
   public:
    BronKerbosch(const std::vector<std::vector<bool>>& adjacent, long nodeCap)
        : adjacent_(adjacent), nodeCap_(nodeCap)
    {
    }

    CliqueResult run()
    {
        Vertices all(adjacent_.size());
        for (std::size_t v = 0; v < all.size(); ++v) all[v] = v;
        greedy(all);
        Vertices clique;
        extend(clique, std::move(all), {});
        std::sort(result_.vertices.begin(), result_.vertices.end());
        return std::move(result_);
    }

   private:
    [[nodiscard]] Vertices neighboursOf(std::size_t v, const Vertices& among) const
    {
        Vertices neighbours;
        for (const std::size_t u : among)
            if (u != v && adjacent_[v][u]) neighbours.push_back(u);
        return neighbours;
    }

    /** Again and again the vertex of most neighbours among those left. */
    void greedy(Vertices left)
    {
        Vertices clique;
        while (!left.empty())
        {
            const std::size_t v = pivot(left, {});
            clique.push_back(v);
            left = neighboursOf(v, left);
        }
        result_.vertices = std::move(clique);
    }

    [[nodiscard]] std::size_t pivot(const Vertices& candidates, const Vertices& excluded) const
    {
        std::size_t best = candidates.empty() ? excluded.front() : candidates.front();
        std::size_t most = 0;
        for (const Vertices* set : {&candidates, &excluded})
            for (const std::size_t v : *set)
            {
                const std::size_t count = neighboursOf(v, candidates).size();
                if (count <= most) continue;
                most = count;
                best = v;
            }
        return best;
    }

    void extend(Vertices& clique, Vertices candidates, Vertices excluded)
    {
        if (result_.nodes >= nodeCap_)
        {
            result_.proved = false;
            return;
        }
        ++result_.nodes;
        if (candidates.empty())
        {
            if (clique.size() > result_.vertices.size()) result_.vertices = clique;
            return;
        }
        const std::size_t p = pivot(candidates, excluded);
        const Vertices order = candidates;
        for (const std::size_t v : order)
        {
            if (clique.size() + candidates.size() <= result_.vertices.size()) return;
            if (v != p && adjacent_[p][v]) continue;
            clique.push_back(v);
            extend(clique, neighboursOf(v, candidates), neighboursOf(v, excluded));
            clique.pop_back();
            candidates.erase(std::find(candidates.begin(), candidates.end(), v));
            excluded.push_back(v);
        }
    }

    const std::vector<std::vector<bool>>& adjacent_;
    long nodeCap_;
    CliqueResult result_;
};
}  // namespace

CliqueResult maximumClique(const std::vector<std::vector<bool>>& adjacent, long nodeCap)
{
    return BronKerbosch(adjacent, nodeCap).run();
}
}  // namespace monoslam
