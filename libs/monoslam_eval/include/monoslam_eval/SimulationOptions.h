// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "monoslam_eval/SyntheticWorld.h"
#include "monoslam_eval/export.h"

namespace mrpt::config
{
class CConfigFileBase;
}

namespace monoslam
{
class ConfigSection;

/** Options of ini section [target]: four known points before the first camera, landmarks 0 to 3. */
struct MONOSLAM_EVAL_EXPORT TargetOptions
{
    double width_m = 0.4;
    double height_m = 0.3;
    double distance_m = 1.0;
    double sigma_m = 0.001;  ///< of each coordinate, as the filter is told and as it is drawn

    static TargetOptions from(ConfigSection section);

    [[nodiscard]] std::vector<Eigen::Vector3d> points() const;
};

/** Options of ini section [wrong_matches]. */
struct MONOSLAM_EVAL_EXPORT WrongMatchesOptions
{
    enum class Kind
    {
        Offset,  ///< a common offset in the image
        Twin,    ///< the image of a twin of the object, shifted in the world
    };
    int landmarks = 0;  ///< of the group, neighbours in the image; 0 = no group
    int first_frame = 60;
    int frames = 5;
    Kind kind = Kind::Offset;
    double offset_px = 10.0;  ///< in a random direction
    double shift_m = 0.05;    ///< in a random direction
    bool hide_true = true;    ///< else both are among the features

    static WrongMatchesOptions from(ConfigSection section);
};

/** Options of ini section [moving]: landmarks that leave their places. */
struct MONOSLAM_EVAL_EXPORT MovingOptions
{
    int landmarks = 0;
    int first_frame = 60;
    double speed_mps = 0.1;  ///< of all, in one random direction

    static MovingOptions from(ConfigSection section);
};

/** A simulation whole: sections [simulation], [path] and those above. */
struct MONOSLAM_EVAL_EXPORT SimulationOptions
{
    int frames = 150;
    int landmarks = 30;  ///< beside the target's
    double nearest_m = 1.0;
    double farthest_m = 5.0;
    double amplitude_m = 0.1;     ///< of the path, see SmoothPath
    double amplitude_rad = 0.05;  ///< of its rotations
    SyntheticWorldOptions world;
    TargetOptions target;
    WrongMatchesOptions wrongMatches;
    MovingOptions moving;

    SimulationOptions();

    /** The camera is left as it is. \throw std::invalid_argument naming file, section and key */
    static SimulationOptions from(const mrpt::config::CConfigFileBase& file,
                                  const std::string& fileName);
};
}  // namespace monoslam
