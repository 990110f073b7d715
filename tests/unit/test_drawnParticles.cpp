// SPDX-License-Identifier: BSD-3-Clause
#include "drawnParticles.h"

#include <gtest/gtest.h>

#include "monoslam_association/fateCounts.h"

namespace monoslam
{
namespace
{
constexpr int kLandmarks = 30;

/** The first \p matched of 30 landmarks matched at \p offset_px beside their pixels. */
DrawnParticle particle(int matched, double logWeight, double offset_px = 0.0)
{
    DrawnParticle drawn;
    drawn.logWeight = logWeight;
    for (int i = 0; i < kLandmarks; ++i)
    {
        Association& a = drawn.outcome.associations.emplace_back();
        a.id = i;
        a.fate = i < matched ? Fate::Matched : Fate::NotFound;
        a.z = Eigen::Vector2d(10.0 * i + offset_px, 50.0);
    }
    return drawn;
}

std::vector<DrawnParticle> list(DrawnParticle a, DrawnParticle b)
{
    return {std::move(a), std::move(b)};
}
}  // namespace

TEST(FateCounts, AreOfAllLandmarks)
{
    std::vector<Association> all(10);
    all[1].fate = all[2].fate = Fate::NotFound;
    all[3].fate = all[4].fate = all[5].fate = Fate::Rejected;
    all[6].fate = all[7].fate = all[8].fate = all[9].fate = Fate::Matched;
    const FateCounts counts = countFates(all);
    EXPECT_EQ(counts.notSearched, 1);
    EXPECT_EQ(counts.notFound, 2);
    EXPECT_EQ(counts.rejected, 3);
    EXPECT_EQ(counts.matched, 4);
    EXPECT_EQ(counts.searched(), 9);
}

TEST(FateCounts, ExplainAFrameByHalfOfTheSearched)
{
    EXPECT_TRUE(explainsFrame({7, 1, 2, 3}));
    EXPECT_FALSE(explainsFrame({0, 2, 2, 3}));
    EXPECT_TRUE(explainsFrame({}));
}

TEST(DrawnParticles, AreTrustedIfTheHeaviestExplainsTheFrame)
{
    EXPECT_TRUE(isTrusted(list(particle(15, -1.0), particle(3, -9.0, 30.0))));
    EXPECT_FALSE(isTrusted(list(particle(15, -9.0), particle(3, -1.0, 30.0))));
    EXPECT_FALSE(isTrusted({particle(14, 0.0)}));
}

TEST(DrawnParticles, AreTrustedIfTwoReadTheFrameAlike)
{
    EXPECT_TRUE(isTrusted(list(particle(6, -1.0), particle(6, -2.0, 0.5))));
    EXPECT_TRUE(isTrusted(list(particle(6, -2.0, 0.5), particle(6, -1.0))));
    EXPECT_FALSE(isTrusted(list(particle(6, -1.0), particle(6, -2.0, 1.5))));
    // Four common pixels may be chance, and five of nine are most but five of ten are not.
    EXPECT_FALSE(isTrusted(list(particle(4, -1.0), particle(4, -2.0))));
    EXPECT_TRUE(isTrusted(list(particle(9, -1.0), particle(5, -2.0))));
    EXPECT_FALSE(isTrusted(list(particle(10, -1.0), particle(5, -2.0))));
}

TEST(DrawnParticles, TheHeaviestGoOnInTheOrderOfTheirOrigins)
{
    std::vector<DrawnParticle> drawn;
    for (const auto& [origin, weight] :
         {std::pair{0u, -5.0}, {1u, -1.0}, {0u, -2.0}, {1u, -4.0}, {0u, -3.0}})
    {
        drawn.push_back(particle(1, weight));
        drawn.back().origin = origin;
    }
    const auto kept = heaviestOf(drawn, 3);
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_EQ(kept[0].logWeight, -2.0);
    EXPECT_EQ(kept[1].logWeight, -3.0);
    EXPECT_EQ(kept[2].logWeight, -1.0);
    EXPECT_EQ(heaviestOf(std::move(drawn), 5)[1].logWeight, -1.0);  // all, as they are
}
}  // namespace monoslam
