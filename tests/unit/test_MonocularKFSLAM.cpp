// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/MonocularKFSLAM.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationImage.h>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "monoslam_association/Associator.h"
#include "monoslam_mrpt/ObservationStream.h"
#include "monoslam_mrpt/RawlogReader.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
using mrpt::config::CConfigFileMemory;
using mrpt::poses::CPose3DQuatPDFGaussian;

constexpr int kFrames = 12;
constexpr unsigned kSeed = 5;
const std::string kIni = "[association]\nstrategy = jcbb\n";

struct State
{
    CPose3DQuatPDFGaussian pose;
    std::vector<mrpt::math::TPoint3D> landmarks;
    std::map<unsigned int, mrpt::maps::CLandmark::TLandmarkID> ids;
    mrpt::math::CVectorDouble x;
    mrpt::math::CMatrixDouble P;
};

State stateOf(const MonocularKFSLAM& slam)
{
    State s;
    slam.getCurrentState(s.pose, s.landmarks, s.ids, s.x, s.P);
    return s;
}

class Facade : public testing::Test
{
   protected:
    Facade() : rawlog_(folder_ / "example.rawlog")
    {
        writeExampleRawlog(rawlog_, exampleTimes(kFrames), true);
    }

    void feed(MonocularKFSLAM& slam) const
    {
        ObservationStream stream(rawlog_);
        while (const auto observation = stream.next())
            static_cast<void>(slam.processObservation(observation));
    }

    TemporaryFolder folder_;
    std::string rawlog_;
};
}  // namespace

TEST_F(Facade, IsTheMonocularFilterToTheLastBit)
{
    MonocularKFSLAM facade(kSeed);
    facade.loadOptions(CConfigFileMemory(kIni));
    feed(facade);

    const CConfigFileMemory ini(kIni);
    RawlogOptions options;
    options.file = rawlog_;
    RawlogReader reader(options, {});
    MonoSlam slam(MonoSlamOptions::from(ini, ""), Camera(reader.camera()),
                  makeAssociator("jcbb", ini), kSeed);
    while (const auto frame = reader.next()) static_cast<void>(slam.process(*frame));

    const Belief& belief = best(slam.mixture());
    const State state = stateOf(facade);
    EXPECT_EQ(Eigen::VectorXd(state.x.asEigen()), belief.x);
    EXPECT_EQ(Eigen::MatrixXd(state.P.asEigen()), belief.P);
    for (unsigned i = 0; i < 7; ++i) EXPECT_EQ(state.pose.mean[i], belief.x[i]);
    EXPECT_EQ(Eigen::MatrixXd(state.pose.cov.asEigen()), belief.P.topLeftCorner(7, 7));
    EXPECT_EQ(state.ids.size(), state.landmarks.size());
    EXPECT_GT(belief.landmarks.size(), 5U);
}

TEST_F(Facade, DrawsAndStartsAnew)
{
    MonocularKFSLAM slam(kSeed);
    slam.loadOptions(CConfigFileMemory(kIni));
    auto objects = mrpt::opengl::CSetOfObjects::Create();
    slam.getAs3DObject(objects);
    const std::size_t empty = objects->size();
    feed(slam);
    const State first = stateOf(slam);
    slam.getAs3DObject(objects);
    EXPECT_GE(objects->size(), empty + first.landmarks.size());

    slam.reset();
    EXPECT_FALSE(slam.hasPose());
    EXPECT_THROW(static_cast<void>(stateOf(slam)), std::logic_error);
    feed(slam);
    const State second = stateOf(slam);
    EXPECT_EQ(Eigen::VectorXd(first.x.asEigen()), Eigen::VectorXd(second.x.asEigen()));
}

TEST_F(Facade, RefusesWhatIsNoImageOfTheCamera)
{
    MonocularKFSLAM slam;
    EXPECT_THROW(slam.loadOptions(CConfigFileMemory("[association]\nstrategy = best\n")),
                 std::invalid_argument);
    EXPECT_THROW(slam.loadOptions(CConfigFileMemory("[motion]\nsigma = 1\n")),
                 std::invalid_argument);
    EXPECT_FALSE(
        slam.processObservation(mrpt::obs::CObservationBearingRange::Create()).has_value());
    EXPECT_THROW(static_cast<void>(slam.processObservation(nullptr)), std::invalid_argument);
    auto image = mrpt::obs::CObservationImage::Create();
    EXPECT_THROW(static_cast<void>(slam.processObservation(image)), std::invalid_argument);
}
}  // namespace monoslam
