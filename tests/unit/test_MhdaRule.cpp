// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/MhdaRule.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "LinearWorld.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam::test
{
namespace
{
constexpr double kArea_px2 = 640.0 * 480.0;

PredictedLandmark landmarkOf(const Eigen::Matrix2d& S)
{
    PredictedLandmark landmark;
    landmark.h = Eigen::Vector2d(300.0, 200.0);
    landmark.S = S;
    landmark.R = 0.25 * Eigen::Matrix2d::Identity();
    return landmark;
}

double logWeightOf(const MhdaRuleOptions& options, const PredictedLandmark& landmark,
                   const std::vector<Candidate>& candidates, unsigned seed = 1)
{
    const CandidateLikelihood likelihood({}, kArea_px2);
    MhdaRule rule(options, likelihood, 5.9915, std::mt19937(seed));
    static_cast<void>(rule.accept(landmark, candidates));
    return rule.logWeight();
}

/** Sum over all associations of the product of likelihoods, each given those before. */
double exactMarginal(const LinearWorld& world, const Belief& belief, std::size_t landmark,
                     const CandidateLikelihood& likelihood)
{
    if (landmark == world.belief.landmarks.size()) return 1.0;
    const Prediction prediction = world.predict(belief);
    double sum =
        std::exp(likelihood.logMissed()) * exactMarginal(world, belief, landmark + 1, likelihood);
    for (const Candidate& c : world.seen.at(static_cast<LandmarkId>(landmark)))
    {
        const double l = std::exp(likelihood.logFound(prediction.rows[landmark], c));
        const Belief updated =
            ekfUpdate(belief, prediction, {{static_cast<Eigen::Index>(landmark), c.z, c.R}});
        sum += l * exactMarginal(world, updated, landmark + 1, likelihood);
    }
    return sum;
}
}  // namespace

TEST(CandidateLikelihood, IntegratesToTheProbabilitiesItIsMadeOf)
{
    LikelihoodOptions options;
    const CandidateLikelihood likelihood(options, kArea_px2);
    double scores = 0.0;
    constexpr int kSteps = 20000;
    const double range = 1.0 - options.min_zncc;
    for (int i = 0; i < kSteps; ++i)  // a(s) p(s | wrong) is a density on [min_zncc, 1]
        scores +=
            std::exp(likelihood.logScoreRatio(options.min_zncc + range * (i + 0.5) / kSteps)) /
            kSteps;
    EXPECT_NEAR(scores, 1.0, 1e-6);
    EXPECT_NEAR(std::exp(likelihood.logMissed()), 0.145, 1e-12);  // eq. (8) of the paper
    EXPECT_NEAR(std::exp(likelihood.logDetection()), 0.855, 1e-12);
    const PredictedLandmark landmark = landmarkOf(4.0 * Eigen::Matrix2d::Identity());
    const Candidate at{landmark.h, 1.0, landmark.R};
    const double ratio =
        std::exp(likelihood.logFound(landmark, at) - likelihood.logScoreRatio(1.0));
    EXPECT_NEAR(ratio, 0.9 / (2.0 * M_PI * 4.0) / (20.0 / kArea_px2), 1e-9 * ratio);
}

TEST(MhdaRule, WeighsAnEmptyRegionAlikeHoweverLarge)
{
    const Eigen::Matrix2d S = Eigen::Vector2d(9.0, 4.0).asDiagonal();
    const double small = logWeightOf({}, landmarkOf(S), {});
    EXPECT_DOUBLE_EQ(small, logWeightOf({}, landmarkOf(100.0 * S), {}));
    EXPECT_NEAR(small, std::log(0.145), 1e-12);
}

TEST(MhdaRule, WeighsByTheRegionInTheLiteralModelOnly)
{
    // One candidate that is surely clutter: the literal likelihood is spread over the region.
    const Eigen::Matrix2d S = Eigen::Vector2d(9.0, 4.0).asDiagonal();
    const Candidate far{{330.0, 230.0}, 0.75, 0.25 * Eigen::Matrix2d::Identity()};
    MhdaRuleOptions literal;
    literal.weight_model = WeightModel::Literal;
    literal.association = AssociationChoice::Map;
    MhdaRuleOptions ratio = literal;
    ratio.weight_model = WeightModel::Ratio;
    const PredictedLandmark one = landmarkOf(S), wide = landmarkOf(2.0 * S);
    EXPECT_NEAR(logWeightOf(literal, one, {far}) - logWeightOf(literal, wide, {far}), std::log(2.0),
                1e-9);
    EXPECT_DOUBLE_EQ(logWeightOf(ratio, one, {far}), logWeightOf(ratio, wide, {far}));
    const double expected = std::log(0.145) - std::log(M_PI * 5.9915 * 6.0) + std::log(20.0) - 20.0;
    EXPECT_NEAR(logWeightOf(literal, one, {far}), expected, 1e-9);
    // Found among n: the formula of the paper, term by term.
    const Candidate right{{301.0, 200.0}, 0.95, 0.25 * Eigen::Matrix2d::Identity()};
    const CandidateLikelihood likelihood({}, kArea_px2);
    const double found = std::log(0.855) + CandidateLikelihood::logDensity({1.0, 0.0}, S) +
                         likelihood.logScoreRatio(0.95) - std::log(2.0) -
                         std::log(M_PI * 5.9915 * 6.0) + std::log(20.0) - 20.0;
    EXPECT_NEAR(logWeightOf(literal, one, {right, far}), found, 1e-9);
}

TEST(MhdaRule, MultipliesByTheSumWhenItDrawsAndByTheChosenWhenItDoesNot)
{
    const PredictedLandmark landmark = landmarkOf(4.0 * Eigen::Matrix2d::Identity());
    const std::vector<Candidate> two{{{301.0, 200.0}, 0.9, landmark.R},
                                     {{297.0, 203.0}, 0.8, landmark.R}};
    const CandidateLikelihood likelihood({}, kArea_px2);
    double sum = std::exp(likelihood.logMissed()), most = 0.0;
    for (const Candidate& c : two)
    {
        sum += std::exp(likelihood.logFound(landmark, c));
        most = std::max(most, std::exp(likelihood.logFound(landmark, c)));
    }
    for (unsigned seed = 1; seed <= 20; ++seed)
        EXPECT_NEAR(logWeightOf({}, landmark, two, seed), std::log(sum), 1e-12);
    MhdaRuleOptions map;
    map.association = AssociationChoice::Map;
    EXPECT_NEAR(logWeightOf(map, landmark, two), std::log(most), 1e-12);
}

TEST(MhdaRule, HasTheExactMarginalAsTheMeanOfItsWeights)
{
    LikelihoodOptions options;
    options.p_search = 1.0 - 1e-9;
    options.clutter_per_image = 2000.0;  // so that "not found" is a real alternative
    const CandidateLikelihood likelihood(options, kArea_px2);
    const double gate = chi2Limit(2, options.p_search);
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        const LinearWorld world = ambiguousWorld(seed);
        const FrameView view = world.view();
        const double exact = exactMarginal(world, world.belief, 0, likelihood);
        double sum = 0.0, squares = 0.0;
        constexpr int kRuns = 4000;
        for (unsigned run = 0; run < kRuns; ++run)
        {
            MhdaRule rule({}, likelihood, gate, std::mt19937(1000 * seed + run));
            static_cast<void>(measureOneByOne(world.belief, view, {gate, 5, 60, {}}, rule));
            const double weight = std::exp(rule.logWeight());
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / kRuns;
        const double sigma = std::sqrt((squares / kRuns - mean * mean) / kRuns);
        EXPECT_GT(sigma, 0.0);
        EXPECT_NEAR(mean, exact, 4.0 * sigma + 1e-9 * exact) << seed;
    }
}
}  // namespace monoslam::test
