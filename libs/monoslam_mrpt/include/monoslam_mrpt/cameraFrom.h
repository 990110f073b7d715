// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/TCamera.h>
#include <mrpt/poses/CPose3D.h>

#include <optional>
#include <string>
#include <vector>

#include "monoslam_models/Camera.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
class ConfigSection;

/** False for MRPT's default of zero focal lengths. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT bool isCalibrated(const mrpt::img::TCamera& camera);

/** \throw std::invalid_argument if it is not calibrated */
[[nodiscard]] MONOSLAM_MRPT_EXPORT CameraParameters cameraFrom(const mrpt::img::TCamera& camera);

/** \throw std::invalid_argument for the distortion models that MRPT has not (tsai, davison) */
[[nodiscard]] MONOSLAM_MRPT_EXPORT mrpt::img::TCamera toTCamera(const CameraParameters& camera);

/** A calibration file and what it says besides. */
struct CameraFile
{
    CameraParameters camera;
    mrpt::poses::CPose3D cameraPose;       ///< on the vehicle; EuRoC's T_BS
    std::vector<std::string> ignoredKeys;  ///< of a yaml
};

/** Reads the yaml of our data sets (width height fx fy cx cy k1 k2 p1 p2 k3), EuRoC's sensor.yaml,
 *  or an MRPT ini (the section with a "resolution", or our [camera]).
 *  \throw std::invalid_argument naming file and key */
[[nodiscard]] MONOSLAM_MRPT_EXPORT CameraFile readCameraFile(const std::string& path);

/** Options of ini section [camera]. */
struct MONOSLAM_MRPT_EXPORT CameraOptions
{
    std::optional<CameraParameters> calibration;  ///< with source = ini; else the rawlog's is used
    double readout_s = 0.0;                       ///< rolling shutter, in both cases
    bool estimateReadout = false;                 ///< from the residuals, beginning with readout_s

    static CameraOptions from(ConfigSection section);

    /** The calibration to use for images that bear `recorded`. */
    [[nodiscard]] CameraParameters choose(const mrpt::img::TCamera& recorded) const;
};
}  // namespace monoslam
