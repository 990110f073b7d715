// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/Belief.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "randomBelief.h"

namespace monoslam
{
namespace
{
constexpr CloneId kClone = 7;  // of randomBelief()

/** Three landmarks of each kind and a clone. */
Belief richBelief(unsigned seed = 1)
{
    std::mt19937 rng(seed);
    return randomBelief(rng, Camera(), {3, 3, true});
}

/** What checkInvariant() says of a belief after something was done to it; empty if all is well. */
std::string complaint(const std::function<void(Belief&)>& spoil)
{
    Belief belief = richBelief();
    spoil(belief);
    try
    {
        belief.checkInvariant();
    }
    catch (const std::logic_error& e)
    {
        return e.what();
    }
    return {};
}

void expectComplaint(const std::string& word, const std::function<void(Belief&)>& spoil)
{
    const std::string said = complaint(spoil);
    EXPECT_NE(said.find(word), std::string::npos) << "expected '" << word << "', got: " << said;
}
}  // namespace

TEST(Belief, OfACameraHasNothingElse)
{
    std::mt19937 rng(2);
    Vector13d x_v;
    x_v << uniformVector<3>(rng, 1.0), randomQuaternion(rng), uniformVector<6>(rng, 1.0);
    const Matrix13d P_v = cameraCovariance(x_v);
    const Belief belief = Belief::ofCamera(x_v, P_v);
    EXPECT_EQ(belief.size(), 13);
    EXPECT_EQ(belief.camera(), x_v);
    EXPECT_EQ(belief.pose(), x_v.head<7>());
    EXPECT_EQ(belief.P, P_v);
    EXPECT_TRUE(belief.landmarks.empty());
    EXPECT_TRUE(belief.clones.empty());
    EXPECT_NO_THROW(belief.checkInvariant());
}

TEST(Belief, FindsLandmarksAndClonesById)
{
    const Belief belief = richBelief();
    ASSERT_EQ(belief.landmarks.size(), 6U);
    for (std::size_t i = 0; i < belief.landmarks.size(); ++i)
        EXPECT_EQ(belief.find(belief.landmarks[i].id), static_cast<Eigen::Index>(i));
    EXPECT_EQ(belief.find(99), -1);
    const CloneSlot* clone = belief.findClone(kClone);
    ASSERT_NE(clone, nullptr);
    EXPECT_EQ(clone, &belief.clones.front());
    EXPECT_EQ(belief.clonePose(*clone), belief.x.segment<7>(clone->offset));
    EXPECT_EQ(belief.findClone(kClone + 1), nullptr);
}

TEST(Belief, SlotsAreAsLongAsTheirKind)
{
    Eigen::Index covered = 13 + 7;
    for (const auto& slot : richBelief().landmarks)
    {
        EXPECT_EQ(slot.size(), slot.kind == LandmarkKind::Point ? 3 : 6);
        covered += slot.size();
    }
    EXPECT_EQ(covered, richBelief().size());
}

TEST(Belief, WhatEditingMakesKeepsTheInvariant)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
        EXPECT_NO_THROW(richBelief(seed).checkInvariant()) << seed;
}

TEST(Belief, InvariantSeesWrongSizesAndOffsets)
{
    EXPECT_EQ(complaint([](Belief&) {}), "");
    expectComplaint("N x N", [](Belief& b) { b.P.conservativeResize(b.size() - 1, b.size() - 1); });
    expectComplaint("N x N", [](Belief& b) { b.P.conservativeResize(b.size(), b.size() + 1); });
    expectComplaint("overlap", [](Belief& b) { b.landmarks[1].offset -= 1; });
    expectComplaint("overlap", [](Belief& b) { b.landmarks[0].offset += 1; });
    expectComplaint("overlap", [](Belief& b) { b.clones[0].offset = 0; });
    expectComplaint("overlap", [](Belief& b) { b.landmarks[0].kind = LandmarkKind::InverseDepth; });
    expectComplaint("gap", [](Belief& b) { b.landmarks.erase(b.landmarks.begin()); });
    expectComplaint("cover", [](Belief& b) { b.clones.clear(); });
}

TEST(Belief, InvariantSeesWrongNumbers)
{
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    expectComplaint("finite", [](Belief& b) { b.x(2) = kNaN; });
    expectComplaint("finite", [](Belief& b) { b.P(4, 4) = kNaN; });
    expectComplaint("symmetric", [](Belief& b) { b.P(0, b.size() - 1) += 1e-6; });
    expectComplaint("camera's quaternion", [](Belief& b) { b.x(3) += 1e-3; });
    expectComplaint("clone's quaternion", [](Belief& b) { b.x(b.clones[0].offset + 4) += 1e-3; });
}

TEST(Belief, RoundingIsNoAsymmetry)
{
    EXPECT_EQ(complaint([](Belief& b) { b.P(0, b.size() - 1) += 1e-13; }), "");
    EXPECT_EQ(complaint([](Belief& b) { b.x.segment<4>(3) *= 1.0 + 1e-12; }), "");
}

TEST(Mixture, BestIsTheHeaviestAndTheSameObject)
{
    Mixture mixture{{richBelief(1), -3.0}, {richBelief(2), -0.5}, {richBelief(3), -1.0}};
    EXPECT_EQ(&best(mixture), &mixture[1].belief);
    best(mixture).x(0) = 42.0;
    EXPECT_EQ(mixture[1].belief.x(0), 42.0);
    mixture[2].logWeight = 0.0;
    const Mixture& unchanging = mixture;
    EXPECT_EQ(&best(unchanging), &mixture[2].belief);
}

TEST(Mixture, AnEmptyOneHasNoBest)
{
    Mixture none;
    EXPECT_THROW((void)best(none), std::logic_error);
}
}  // namespace monoslam
