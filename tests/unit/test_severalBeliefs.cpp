// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "exampleCameras.h"
#include "monoslam_slam/MonoSlam.h"
#include "texture.h"

namespace monoslam::test
{
namespace
{
constexpr LandmarkId kUnluckyBelow = 20;  ///< not found by the second belief

/** Two beliefs that see the same pixels; the second one finds no old landmark. After \p heir frames
 *  both descend from the second. */
class Split : public Associator
{
   public:
    explicit Split(int heir) : heir_(heir) {}
    [[nodiscard]] AssociatorTraits traits() const override { return {}; }
    [[nodiscard]] Correction correct(Mixture predicted, const FrameView& view,
                                     std::mt19937& /*rng*/) const override
    {
        ++frames_;
        Correction correction;
        const std::size_t last = predicted.size() - 1;
        correction.parents = {frames_ == heir_ ? last : 0, last};
        for (const std::size_t parent : correction.parents)
            correction.mixture.push_back({predicted[parent].belief, 0.0, {}});
        correction.mixture[1].logWeight = -1.0;
        for (std::size_t b = 0; b < 2; ++b)
        {
            std::vector<Association>& list = correction.ofEveryBelief.emplace_back();
            for (const PredictedLandmark& row : view.predict(correction.mixture[b].belief).rows)
            {
                Association& seen = list.emplace_back();
                seen.id = row.id;
                seen.h = seen.z = row.h;
                seen.S = row.S;
                seen.R = row.R;
                seen.fate = b == 1 && row.id < kUnluckyBelow ? Fate::NotFound : Fate::Matched;
            }
        }
        correction.associations = correction.ofEveryBelief.front();
        correction.diversity = diversityOf(correction.mixture);
        return correction;
    }

   private:
    int heir_;
    mutable int frames_ = 0;
};

struct SplitRun
{
    MonoSlam slam;
    FrameReport report;
    cv::Mat image;
    long frame = 0;

    explicit SplitRun(int heir, InitializationMethod method = InitializationMethod::Undelayed)
        : slam(options(method), Camera(cameraParameters(DistortionModel::None, {})),
               std::make_unique<Split>(heir), 1),
          image(renderImage(
              640, 480, [texture = Texture(3)](double u, double v) { return texture.at(u, v); }))
    {
    }
    void step(int frames)
    {
        for (; frames > 0; --frames, ++frame)
            report = slam.process({0.04 * static_cast<double>(frame), image, frame});
    }
    static MonoSlamOptions options(InitializationMethod method)
    {
        MonoSlamOptions o;
        o.start.parallax_deg.clear();
        o.initialization.method = method;
        return o;
    }
};

std::set<LandmarkId> idsOf(const Belief& belief)
{
    std::set<LandmarkId> ids;
    for (const LandmarkSlot& slot : belief.landmarks) ids.insert(slot.id);
    return ids;
}
}  // namespace

TEST(SeveralBeliefs, EachDeletesByItsOwnRecord)
{
    SplitRun run(1000);
    run.step(4);
    ASSERT_EQ(run.slam.mixture().size(), 2);
    const auto before = idsOf(run.slam.mixture()[0].belief);
    ASSERT_GT(before.size(), 25);
    EXPECT_EQ(before, idsOf(run.slam.mixture()[1].belief));
    run.step(4);  // more than min_searched searches in vain
    const auto first = idsOf(run.slam.mixture()[0].belief);
    const auto second = idsOf(run.slam.mixture()[1].belief);
    for (const LandmarkId id : before)
    {
        EXPECT_EQ(first.count(id), 1) << id;
        EXPECT_EQ(second.count(id), id < kUnluckyBelow ? 0 : 1) << id;
    }
    for (const auto& weighted : run.slam.mixture()) weighted.belief.checkInvariant();
    EXPECT_EQ(run.report.removed, 0);  // the map that is reported lost nothing
    for (const MapLandmark& landmark : run.slam.map()) EXPECT_GE(landmark.timesSeen, 7);
    EXPECT_EQ(run.report.diversity.beliefs, 2);
}

TEST(SeveralBeliefs, ChildrenInheritTheRecordOfTheirParent)
{
    SplitRun run(9);
    run.step(8);
    EXPECT_EQ(idsOf(run.slam.mixture()[0].belief).count(0), 1);
    run.step(2);  // both descend from the second now, and so does the map
    const auto ids = idsOf(run.slam.mixture()[0].belief);
    EXPECT_EQ(ids.count(0), 0);
    for (const MapLandmark& landmark : run.slam.map()) EXPECT_EQ(ids.count(landmark.id), 1);
    // The places are free again: new landmarks, the same for both, with ids never used before.
    run.step(3);
    for (const LandmarkId id : idsOf(run.slam.mixture()[0].belief))
        if (ids.count(id) == 0)
        {
            EXPECT_EQ(idsOf(run.slam.mixture()[1].belief).count(id), 1);
        }
    EXPECT_GT(*idsOf(run.slam.mixture()[0].belief).rbegin(), *ids.rbegin());
}

TEST(SeveralBeliefs, GetTheSameNewLandmarks)
{
    for (const auto method : {InitializationMethod::Undelayed, InitializationMethod::Delayed})
    {
        SplitRun run(3, method);
        run.step(8);
        ASSERT_EQ(run.slam.mixture().size(), 2);
        std::set<CloneId> first, second;
        for (const auto& clone : run.slam.mixture()[0].belief.clones) first.insert(clone.id);
        for (const auto& clone : run.slam.mixture()[1].belief.clones) second.insert(clone.id);
        EXPECT_EQ(first, second);
        for (const auto& weighted : run.slam.mixture()) weighted.belief.checkInvariant();
    }
}
}  // namespace monoslam::test
