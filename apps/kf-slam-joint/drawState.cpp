// SPDX-License-Identifier: BSD-3-Clause
#include "drawState.h"

#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/stock_objects.h>

#include <algorithm>

namespace monoslam
{
using namespace mrpt::opengl;
using mrpt::poses::CPose3D;

namespace
{
constexpr std::size_t kStepsBetweenCorners = 11;

CSetOfLines::Ptr lines(float red, float green, float blue)
{
    auto set = CSetOfLines::Create();
    set->setColor(red, green, blue);
    return set;
}

void append(CSetOfLines& set, const CPose3D& a, const mrpt::math::TPoint3D& b)
{
    set.appendLine(a.x(), a.y(), a.z(), b.x, b.y, b.z);
}

CSetOfLines::Ptr along(CSetOfLines::Ptr set, const std::vector<CPose3D>& path, std::size_t steps)
{
    for (std::size_t i = 1; i < steps; ++i)
        append(*set, path[i - 1], path[i].asTPose().translation());
    return set;
}

CSetOfObjects::Ptr corner(const CPose3D& pose, float size, float width)
{
    auto xyz = stock_objects::CornerXYZSimple(size, width);
    xyz->setPose(pose);
    return xyz;
}
}  // namespace

COpenGLScene::Ptr drawState(const Filter& filter, const std::vector<CPose3D>& path,
                            const std::vector<CPose3D>& truth)
{
    auto scene = COpenGLScene::Create();
    auto grid = CGridPlaneXY::Create(-1000.0f, 1000.0f, -1000.0f, 1000.0f, 0.0f, 5.0f);
    grid->setColor(0.4f, 0.4f, 0.4f);
    scene->insert(grid);
    scene->insert(along(lines(1.0f, 0.0f, 0.0f), path, path.size()));
    for (std::size_t i = kStepsBetweenCorners - 1; i < path.size(); i += kStepsBetweenCorners)
        scene->insert(corner(path[i], 0.3f, 2.0f));
    scene->insert(corner(path.back(), 1.0f, 2.5f));
    if (!truth.empty())
        scene->insert(along(lines(0.0f, 0.0f, 0.0f), truth, std::min(truth.size(), path.size())));

    auto associations = lines(1.0f, 1.0f, 1.0f);
    associations->setLineWidth(1.2f);
    const auto pairs = filter.associations();
    for (const MappedLandmark& landmark : filter.landmarks())
        if (std::any_of(pairs.begin(), pairs.end(),
                        [&](const auto& pair) { return pair.second == landmark.serial; }))
            append(*associations, path.back(), landmark.position);
    scene->insert(associations);

    auto state = CSetOfObjects::Create();
    filter.drawInto(state);
    scene->insert(state);
    return scene;
}
}  // namespace monoslam
