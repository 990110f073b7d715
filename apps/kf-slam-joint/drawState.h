// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/COpenGLScene.h>

#include <vector>

#include "Filter.h"

namespace monoslam
{
/** The scene that kf-slam saves: grid, path (red), true path (black), lines to the associated
 *  landmarks (white), ellipsoids. \param path  not empty */
[[nodiscard]] mrpt::opengl::COpenGLScene::Ptr drawState(
    const Filter& filter, const std::vector<mrpt::poses::CPose3D>& path,
    const std::vector<mrpt::poses::CPose3D>& truth);
}  // namespace monoslam
