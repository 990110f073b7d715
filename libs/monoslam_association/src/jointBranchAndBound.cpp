// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/jointBranchAndBound.h"

namespace monoslam
{
namespace
{
class Jcbb
{
   public:
    Jcbb(const JcbbProblem& problem, const Chi2Table& limits, const JcbbOptions& options)
        : problem_(problem),
          limits_(limits),
          options_(options),
          d2_(*problem.HPHt, static_cast<Eigen::Index>(problem.pairs.size())),
          chosen_(problem.pairs.size(), -1)
    {
        result_.chosen = chosen_;
    }

    JcbbResult run()
    {
        if (!fullSetIsCompatible())
        {
            result_.searched = true;
            branch(0);
        }
        return std::move(result_);
    }

   private:
    [[nodiscard]] std::size_t left(std::size_t i) const { return problem_.pairs.size() - i; }

    bool fullSetIsCompatible()
    {
        std::size_t i = 0;
        while (i < problem_.pairs.size() && free(i, 0) && push(i, 0)) ++i;
        const bool all = i == problem_.pairs.size();
        const bool compatible = all && d2_.d2() <= limits_(2 * d2_.pairs());
        if (compatible) keepBest();
        while (i > 0) pop(--i);
        return compatible;
    }

    bool push(std::size_t i, std::size_t c)
    {
        ++result_.d2Evaluations;
        if (!d2_.push(problem_.pairs[i][c])) return false;
        chosen_[i] = static_cast<int>(c);
        return true;
    }

    void pop(std::size_t i)
    {
        d2_.pop();
        chosen_[i] = -1;
    }

    void keepBest()
    {
        result_.chosen = chosen_;
        result_.d2 = d2_.d2();
        best_ = static_cast<std::size_t>(d2_.pairs());
    }

    [[nodiscard]] bool beatsBest(std::size_t pairs) const
    {
        return pairs > best_ || (pairs == best_ && d2_.d2() < result_.d2);
    }

    [[nodiscard]] bool worthwhile(std::size_t undecided) const
    {
        return !options_.bound || beatsBest(static_cast<std::size_t>(d2_.pairs()) + undecided);
    }

    [[nodiscard]] bool free(std::size_t i, std::size_t c) const
    {
        if (problem_.pixels.empty()) return true;
        const Eigen::Vector2d& z = problem_.pixels[i][c];
        for (std::size_t j = 0; j < i; ++j)
            if (chosen_[j] >= 0 && problem_.pixels[j][static_cast<std::size_t>(chosen_[j])] == z)
                return false;
        return true;
    }

    void branch(std::size_t i)
    {
        if (result_.nodes >= options_.node_cap)
        {
            result_.finished = false;
            if (beatsBest(static_cast<std::size_t>(d2_.pairs()))) keepBest();
            return;
        }
        ++result_.nodes;
        if (i == problem_.pairs.size())
        {
            ++result_.leaves;
            if (beatsBest(static_cast<std::size_t>(d2_.pairs()))) keepBest();
            return;
        }
        for (std::size_t c = 0; c < problem_.pairs[i].size(); ++c)
        {
            if (!free(i, c) || !push(i, c)) continue;
            if (d2_.d2() <= limits_(2 * d2_.pairs()) && worthwhile(left(i + 1))) branch(i + 1);
            pop(i);
        }
        if (worthwhile(left(i + 1))) branch(i + 1);
    }

    const JcbbProblem& problem_;
    const Chi2Table& limits_;
    JcbbOptions options_;
    IncrementalD2 d2_;
    std::vector<int> chosen_;
    std::size_t best_ = 0;
    JcbbResult result_;
};
}  // namespace

JcbbResult jointBranchAndBound(const JcbbProblem& problem, const Chi2Table& limits,
                               const JcbbOptions& options)
{
    return Jcbb(problem, limits, options).run();
}
}  // namespace monoslam
