// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "associatorRuns.h"
#include "monoslam_association/drawParents.h"

namespace monoslam::test
{
namespace
{
bool sharesAPixel(const LinearWorld& world)
{
    for (const auto& [a, first] : world.seen)
        for (const auto& [b, second] : world.seen)
            if (a != b && (first.front().z - second.front().z).norm() < 3.0) return true;
    return false;
}
}  // namespace

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

TEST(Mhda, DrawsAgainWhereNoParticleExplainsTheFrame)
{
    LinearWorld world = LinearWorld::withLandmarks(20, 8);
    std::mt19937 places(1);
    std::uniform_real_distribution<double> angle(0.0, 2.0 * M_PI);
    for (auto& [id, candidates] : world.seen)
    {
        // Each landmark has a double elsewhere: no two of them agree about the camera.
        const double direction = angle(places);
        Candidate other = candidates.front();
        other.z += 14.0 * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        candidates.push_back(other);
    }
    const auto unexplained = [&world](int particles, int redraws)
    {
        const mrpt::config::CConfigFileMemory file(
            "[association.mhda]\nparticles = " + std::to_string(particles) +
            "\nredraws = " + std::to_string(redraws) + "\n");
        const auto mhda = makeAssociator("mhda", file);
        int frames = 0;
        for (unsigned seed = 0; seed < 50; ++seed)
        {
            std::mt19937 rng(seed);
            const Correction c = mhda->correct({{world.belief, 0.0}}, world.view(), rng);
            EXPECT_EQ(c.mixture.size(), particles);
            EXPECT_EQ(c.parents, std::vector<std::size_t>(c.mixture.size(), 0));
            EXPECT_EQ(c.diversity.ancestorAge_frames, particles > 1 ? 1 : 0);
            frames += count(c, Fate::Matched) < 10 ? 1 : 0;
        }
        return frames;
    };
    EXPECT_GE(unexplained(1, 0), 10);
    EXPECT_EQ(unexplained(1, 20), 0);
    EXPECT_GE(unexplained(2, 0), 3);
    EXPECT_EQ(unexplained(2, 10), 0);
}

TEST(Mhda, RefusesOptionsOutOfRange)
{
    const LinearWorld world = LinearWorld::withLandmarks(1, 7);
    for (const char* bad :
         {"particles = 0", "particles = 65", "p_present = 1", "threads = 0", "weight_model = other",
          "redraws = -1", "association = best", "resampling = none"})
        EXPECT_THROW(run("mhda", world, std::string("[association.mhda]\n") + bad),
                     std::invalid_argument)
            << bad;
}
}  // namespace monoslam::test
