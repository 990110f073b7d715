// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "associatorRuns.h"
#include "monoslam_association/MhdaRule.h"
#include "monoslam_association/drawParents.h"
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

bool sharesAPixel(const LinearWorld& world)
{
    for (const auto& [a, first] : world.seen)
        for (const auto& [b, second] : world.seen)
            if (a != b && (first.front().z - second.front().z).norm() < 3.0) return true;
    return false;
}

/** Two landmarks of two candidates each, all of which may be right. */
LinearWorld ambiguousWorld(unsigned seed)
{
    LinearWorld world = LinearWorld::withLandmarks(2, seed);
    for (auto& [id, candidates] : world.seen)
        candidates.push_back(
            {candidates.front().z + Eigen::Vector2d(6.0, -5.0 + 2.0 * id), 0.85, 0.5 * world.R()});
    return world;
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

TEST(DrawParents, DrawsByWeight)
{
    const std::vector<double> weights{1.0, 0.0, 6.0, 3.0};
    std::mt19937 rng(1);
    for (const Resampling scheme : {Resampling::Multinomial, Resampling::Systematic})
    {
        std::vector<double> counts(4, 0.0);
        constexpr int kRuns = 5000;
        for (int run = 0; run < kRuns; ++run)
        {
            const auto parents = drawParents(weights, 10, scheme, 0.5, rng);
            ASSERT_EQ(parents.size(), 10);
            EXPECT_TRUE(std::is_sorted(parents.begin(), parents.end()));
            for (const std::size_t p : parents) counts[p] += 0.1 / kRuns;
        }
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(counts[i], weights[i] / 10.0, 0.01);
    }
}

TEST(DrawParents, KeepsEqualWeightsSystematicallyButNotMultinomially)
{
    std::mt19937 rng(2);
    int both = 0;
    for (int run = 0; run < 2000; ++run)
    {
        EXPECT_EQ(drawParents({0.5, 0.5}, 2, Resampling::Systematic, 0.5, rng),
                  (std::vector<std::size_t>{0, 1}));
        EXPECT_TRUE(drawParents({0.5, 0.5}, 2, Resampling::Neff, 0.65, rng).empty());
        EXPECT_EQ(drawParents({0.999, 0.001}, 2, Resampling::Neff, 0.65, rng).size(), 2);
        both += drawParents({0.5, 0.5}, 2, Resampling::Multinomial, 0.5, rng).front() == 0 ? 1 : 0;
    }
    EXPECT_EQ(drawParents({1.0}, 3, Resampling::Neff, 0.65, rng),
              (std::vector<std::size_t>{0, 0, 0}));
    EXPECT_NEAR(both / 2000.0, 0.75, 0.04);  // at least one of the two draws is the first
}

TEST(Mhda, AloneAndGreedyIsActiveSearch)
{
    int worlds = 0;
    for (unsigned seed = 1; worlds < 5; ++seed)
    {
        const LinearWorld world = LinearWorld::withLandmarks(25, seed);
        if (sharesAPixel(world)) continue;  // it goes to whom is measured first
        ++worlds;
        // Gates that lose nothing and hardly any clutter: both take every candidate.
        const Correction active = run("active_search", world,
                                      "gate_probability = 0.9999999\n"
                                      "[association.active_search]\nstop_bits = 0");
        const Correction alone = run("mhda", world,
                                     "[association.mhda]\nparticles = 1\nassociation = map\n"
                                     "p_search = 0.9999999\nclutter_per_image = 1e-6");
        ASSERT_EQ(alone.mixture.size(), 1);
        for (const Association& record : active.associations)
            EXPECT_EQ(record.fate, recordOf(alone, record.id).fate);
        const Belief &a = best(active.mixture), &b = best(alone.mixture);
        EXPECT_LT((a.x - b.x).cwiseAbs().maxCoeff(), 1e-9);  // linear: the order does not matter
        EXPECT_LT((a.P - b.P).cwiseAbs().maxCoeff(), 1e-9);
    }
}

TEST(Mhda, GivesTheSameBitsWithAnyNumberOfThreads)
{
    const LinearWorld world = ambiguousWorld(4);
    const std::string ini = "[association.mhda]\nparticles = 9\nthreads = ";
    const Correction serial = run("mhda", world, ini + "1");
    for (const char* threads : {"2", "4", "64"})
    {
        const Correction parallel = run("mhda", world, ini + threads);
        ASSERT_EQ(parallel.mixture.size(), 9);
        for (std::size_t i = 0; i < 9; ++i)
        {
            EXPECT_EQ(parallel.mixture[i].belief.x, serial.mixture[i].belief.x);
            EXPECT_EQ(parallel.mixture[i].belief.P, serial.mixture[i].belief.P);
            EXPECT_EQ(parallel.mixture[i].logWeight, serial.mixture[i].logWeight);
        }
    }
}

TEST(Mhda, CarriesBothReadingsOfAnAmbiguousFrameUntilTheNextDecides)
{
    LinearWorld world = LinearWorld::withLandmarks(1, 5);
    world.belief.P(0, 0) = world.belief.P(1, 1) = 15.0 * 15.0;
    const Eigen::Vector2d h = world.predict(world.belief).rows[0].h;
    const Eigen::Vector2d apart(12.0, 0.0);
    world.seen[0] = {{h + apart, 0.9, world.R()}, {h - apart, 0.9, world.R()}};
    const mrpt::config::CConfigFileMemory file("[association.mhda]\nparticles = 16\n");
    const auto mhda = makeAssociator("mhda", file);
    std::mt19937 rng(3);
    Correction first = mhda->correct({{world.belief, 0.0}}, world.view(), rng);
    EXPECT_GT(first.diversity.distance, 20.0);
    EXPECT_EQ(first.diversity.beliefs, 16);
    EXPECT_EQ(first.diversity.ancestorAge_frames, 1);
    EXPECT_EQ(first.parents, std::vector<std::size_t>(16, 0));

    world.seen[0] = {{h - apart, 0.9, world.R()}};
    const Correction second = mhda->correct(std::move(first.mixture), world.view(), rng);
    EXPECT_LT((best(second.mixture).x.head<2>() - world.belief.x.head<2>() + apart).norm(), 2.0);
    EXPECT_EQ(recordOf(second, 0).fate, Fate::Matched);
    double right = 0.0;
    for (const auto& particle : second.mixture)
        right += particle.belief.x(0) < world.belief.x(0) ? std::exp(particle.logWeight) : 0.0;
    EXPECT_GT(right, 0.99);
}

TEST(Mhda, CountsTheFramesSinceTheCommonAncestor)
{
    const LinearWorld world = LinearWorld::withLandmarks(6, 6);
    const mrpt::config::CConfigFileMemory file(
        "[association.mhda]\nparticles = 4\nresampling = neff\nneff_share = 1e-6\n");
    const auto mhda = makeAssociator("mhda", file);
    std::mt19937 rng(4);
    Mixture mixture{{world.belief, 0.0}};
    for (long frame = 1; frame <= 5; ++frame)
    {
        Correction correction = mhda->correct(std::move(mixture), world.view(), rng);
        EXPECT_EQ(correction.diversity.ancestorAge_frames, frame);  // never resampled
        EXPECT_EQ(correction.ofEveryBelief.size(), 4);
        double sum = 0.0;
        for (const auto& particle : correction.mixture) sum += std::exp(particle.logWeight);
        EXPECT_NEAR(sum, 1.0, 1e-12);
        mixture = std::move(correction.mixture);
    }
}

TEST(Mhda, RefusesOptionsOutOfRange)
{
    const LinearWorld world = LinearWorld::withLandmarks(1, 7);
    for (const char* bad : {"particles = 0", "particles = 65", "p_present = 1", "threads = 0",
                            "weight_model = other", "association = best", "resampling = none"})
        EXPECT_THROW(run("mhda", world, std::string("[association.mhda]\n") + bad),
                     std::invalid_argument)
            << bad;
}
}  // namespace monoslam::test
