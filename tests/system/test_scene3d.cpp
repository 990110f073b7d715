// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/scene3d.h"

#include <gtest/gtest.h>
#include <mrpt/opengl/CEllipsoid3D.h>
#include <mrpt/opengl/CSetOfLines.h>

#include "TemporaryFolder.h"

namespace monoslam
{
namespace
{
std::vector<Vector7d> examplePath()
{
    std::vector<Vector7d> path(3, Vector7d::Zero());
    for (std::size_t i = 0; i < path.size(); ++i)
        path[i][0] = 0.1 * static_cast<double>(i), path[i][3] = 1.0;
    return path;
}

std::vector<MapLandmark> exampleMap()
{
    MapLandmark near, unknownDepth;
    near.kind = LandmarkKind::Point;
    near.y = Eigen::Vector3d(0.0, 0.1, 2.0);
    near.P_y = 1e-4 * Eigen::Matrix3d::Identity();
    unknownDepth.y = Eigen::VectorXd::Zero(6);
    unknownDepth.P_y = Eigen::MatrixXd::Identity(6, 6);
    return {near, unknownDepth};
}

TEST(Scene3d, HoldsPathCameraAndAnEllipsoidForEveryFinitePoint)
{
    TemporaryFolder folder;
    writeScene3d(folder / "map.3Dscene", examplePath(), exampleMap());
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile(folder / "map.3Dscene"));
    EXPECT_TRUE(scene.getByClass<mrpt::opengl::CSetOfLines>(1));
    const auto ellipsoid = scene.getByClass<mrpt::opengl::CEllipsoid3D>(0);
    ASSERT_TRUE(ellipsoid);
    EXPECT_NEAR(ellipsoid->getPoseZ(), 2.0, 1e-9);
    EXPECT_FALSE(scene.getByClass<mrpt::opengl::CEllipsoid3D>(1));
}

TEST(Scene3d, OfAnEmptyRunCanBeWritten)
{
    TemporaryFolder folder;
    EXPECT_NO_THROW(writeScene3d(folder / "map.3Dscene", {}, {}));
}
}  // namespace
}  // namespace monoslam
