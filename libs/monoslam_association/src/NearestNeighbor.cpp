// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "monoslam_association/BatchAssociator.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** The best-scoring candidate of each gate, accepted as it is. */
class AppearanceNN : public BatchAssociator
{
   public:
    using BatchAssociator::BatchAssociator;
    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.appearance = true;
        return t;
    }

   private:
    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters&) const override
    {
        return std::vector<int>(problem.rows.size(), 0);
    }
};

/** The candidate of least Mahalanobis distance from the centre of the region searched. */
class SpatialNN : public BatchAssociator
{
   public:
    using BatchAssociator::BatchAssociator;
    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = true;
        return t;
    }

   private:
    static constexpr int kCandidates = 5;

    [[nodiscard]] int maxCandidates() const override { return kCandidates; }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        std::vector<int> chosen(problem.rows.size(), 0);
        for (std::size_t i = 0; i < chosen.size(); ++i)
        {
            const SearchRegion& region = problem.regions[i];
            const Eigen::Matrix2d precision = region.S.inverse();
            double least = 0.0;
            for (std::size_t c = 0; c < problem.candidates[i].size(); ++c)
            {
                const Eigen::Vector2d nu = problem.candidates[i][c].z - region.centre;
                const double d2 = nu.dot(precision * nu);
                ++counters.d2Evaluations;
                if (c > 0 && d2 >= least) continue;
                least = d2;
                chosen[i] = static_cast<int>(c);
            }
        }
        return chosen;
    }
};
}  // namespace

std::unique_ptr<Associator> makeUnvalidated(const IniFile& file, const std::string& fileName)
{
    return makeAppearanceNN(file, fileName);
}

std::unique_ptr<Associator> makeAppearanceNN(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<AppearanceNN>(BatchOptions::from(file, fileName));
}

std::unique_ptr<Associator> makeSpatialNN(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<SpatialNN>(BatchOptions::from(file, fileName));
}
}  // namespace monoslam
