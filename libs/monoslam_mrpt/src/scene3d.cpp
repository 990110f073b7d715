// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/scene3d.h"

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/opengl/CEllipsoid3D.h>
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/stock_objects.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <stdexcept>

#include "monoslam_mrpt/registerAllClasses.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
using namespace mrpt::opengl;
using mrpt::poses::CPose3D;

namespace
{
CPose3D poseOf(const Vector7d& pose)
{
    mrpt::math::CQuaternionDouble q(pose[3], pose[4], pose[5], pose[6]);
    q.normalize();
    return CPose3D(q, pose[0], pose[1], pose[2]);
}

/** What the sizes of symbols relate to: the extent of the path, or the landmarks' distance. */
double extentOf(const std::vector<Vector7d>& path, const std::vector<MapLandmark>& map)
{
    if (path.empty()) return 1.0;
    double extent = 0.0;
    for (const auto& pose : path)
        extent = std::max(extent, (pose.head<3>() - path.front().head<3>()).norm());
    std::vector<double> distances;
    for (const auto& landmark : map)
        if (const auto point = pointOf(landmark))
            distances.push_back((point->p - path.back().head<3>()).norm());
    const auto middle = distances.begin() + static_cast<long>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return std::max(extent, distances.empty() ? 0.1 : *middle);
}

/** A pyramid that opens along the camera's z, of that length. */
CSetOfLines::Ptr cameraOf(const Vector7d& pose, double length)
{
    auto camera = CSetOfLines::Create();
    camera->setColor_u8(0xd0, 0x60, 0x00);
    camera->setLineWidth(3.0f);
    const double x = 0.6 * length, y = 0.45 * length;
    const double corners[5][2] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}, {-x, -y}};
    for (int i = 0; i < 4; ++i)
    {
        camera->appendLine(0.0, 0.0, 0.0, corners[i][0], corners[i][1], length);
        camera->appendLine(corners[i][0], corners[i][1], length, corners[i + 1][0],
                           corners[i + 1][1], length);
    }
    camera->setPose(poseOf(pose));
    return camera;
}

CSetOfLines::Ptr linesOf(const std::vector<Vector7d>& path)
{
    auto lines = CSetOfLines::Create();
    lines->setColor_u8(0x20, 0x50, 0xd0);
    lines->setLineWidth(2.0f);
    for (std::size_t i = 1; i < path.size(); ++i)
        lines->appendLine(path[i - 1][0], path[i - 1][1], path[i - 1][2], path[i][0], path[i][1],
                          path[i][2]);
    return lines;
}

CEllipsoid3D::Ptr ellipsoidOf(const LandmarkPoint& point, bool known)
{
    auto ellipsoid = CEllipsoid3D::Create();
    mrpt::math::CMatrixDouble33 P;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) P(i, j) = point.P(i, j);
    ellipsoid->setCovMatrix(P);
    ellipsoid->setQuantiles(3.0f);
    ellipsoid->enableDrawSolid3D(false);
    ellipsoid->setColor_u8(known ? 0xd0 : 0x10, known ? 0x20 : 0x90, 0x20);
    ellipsoid->setLocation(point.p.x(), point.p.y(), point.p.z());
    return ellipsoid;
}
}  // namespace

CSetOfObjects::Ptr mapObjects(const std::vector<Vector7d>& path,
                              const std::vector<MapLandmark>& map)
{
    auto objects = CSetOfObjects::Create();
    const double extent = extentOf(path, map);
    objects->insert(stock_objects::CornerXYZSimple(static_cast<float>(0.1 * extent), 2.0f));
    auto points = CPointCloud::Create();
    points->setPointSize(3.0f);
    points->setColor_u8(0x00, 0x60, 0x10);
    for (const auto& landmark : map)
    {
        const auto point = pointOf(landmark);
        if (!point) continue;
        points->insertPoint(static_cast<float>(point->p.x()), static_cast<float>(point->p.y()),
                            static_cast<float>(point->p.z()));
        objects->insert(ellipsoidOf(*point, landmark.known));
    }
    objects->insert(points);
    if (path.empty()) return objects;
    objects->insert(linesOf(path));
    objects->insert(cameraOf(path.back(), 0.1 * extent));
    return objects;
}

COpenGLScene::Ptr scene3d(const std::vector<Vector7d>& path, const std::vector<MapLandmark>& map)
{
    auto scene = COpenGLScene::Create();
    const double extent = extentOf(path, map);
    const auto size = static_cast<float>(2.0 * extent);
    auto grid = CGridPlaneXY::Create(-size, size, -size, size, 0.0f, size / 10.0f);
    grid->setColor_u8(0xc0, 0xc0, 0xc0);
    scene->insert(grid);
    const auto objects = mapObjects(path, map);
    for (const auto& object : *objects) scene->insert(object);
    if (path.empty()) return scene;
    auto& view = scene->getViewport()->getCamera();
    view.setZoomDistance(static_cast<float>(3.0 * extent));
    view.setPointingAt(path.back()[0], path.back()[1], path.back()[2]);
    return scene;
}

void writeScene3d(const std::string& file, const std::vector<Vector7d>& path,
                  const std::vector<MapLandmark>& map)
{
    registerAllClasses();
    OutputFile probe(file);  // says why, which MRPT does not
    if (!scene3d(path, map)->saveToFile(file))
        throw std::runtime_error(file + ": cannot be written");
    COpenGLScene readBack;
    if (!readBack.loadFromFile(file))
        throw std::runtime_error(file + ": cannot be written completely (disk full?)");
}
}  // namespace monoslam
