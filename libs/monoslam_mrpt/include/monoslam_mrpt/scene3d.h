// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <string>
#include <vector>

#include "monoslam_mrpt/export.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
/** Camera, path, landmarks and their ellipsoids (3 sigma).
 *  \param path  poses (r_wc, q_wc), the last is the camera's */
[[nodiscard]] MONOSLAM_MRPT_EXPORT mrpt::opengl::CSetOfObjects::Ptr mapObjects(
    const std::vector<Vector7d>& path, const std::vector<MapLandmark>& map);

/** These on a grid, for SceneViewer3D. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT mrpt::opengl::COpenGLScene::Ptr scene3d(
    const std::vector<Vector7d>& path, const std::vector<MapLandmark>& map);

/** \throw std::runtime_error naming the file */
MONOSLAM_MRPT_EXPORT void writeScene3d(const std::string& file, const std::vector<Vector7d>& path,
                                       const std::vector<MapLandmark>& map);
}  // namespace monoslam
