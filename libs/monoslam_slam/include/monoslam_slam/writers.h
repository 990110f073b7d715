// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_slam/FrameReport.h"
#include "monoslam_slam/export.h"

namespace monoslam
{
/** A text file that throws std::runtime_error, naming itself, as soon as it cannot be written. */
class MONOSLAM_SLAM_EXPORT OutputFile
{
   public:
    explicit OutputFile(const std::string& path);

    /** Writes and flushes, so that an interrupted run leaves only complete lines; where there is no
     *  room for all of them, none is left. */
    void write(const std::string& lines);

   private:
    std::string path_;
    std::ofstream stream_;
    std::uintmax_t size_ = 0;
};

/** Writes a text file, /dev/stdout among them.
 *  \throw std::runtime_error naming it if it exists and force is not set, or cannot be written */
MONOSLAM_SLAM_EXPORT void writeTextFile(const std::string& path, const std::string& text,
                                        bool force);

/** The folder may be used if it is absent, empty, or force is set.
 *  \throw std::runtime_error naming the folder */
MONOSLAM_SLAM_EXPORT void checkOutputFolder(const std::string& folder, bool force);

/** Checks and creates the folder; removes what an earlier run left in it and nothing else. */
MONOSLAM_SLAM_EXPORT void prepareOutputFolder(const std::string& folder, bool force);

/** "t x y z qx qy qz qw" of a pose (r_wc, q_wc), with a line end; t to 100 ns. */
[[nodiscard]] MONOSLAM_SLAM_EXPORT std::string tumLine(double t_s, const Vector7d& pose);

/** trajectory.tum, covariance.csv and frames.csv, a line a frame as it comes. */
class MONOSLAM_SLAM_EXPORT FrameWriters
{
   public:
    explicit FrameWriters(const std::string& folder);

    /** \param decode_ms  time of reading and decoding the image, which no stage contains */
    void write(const FrameReport& report, double decode_ms = 0.0);

   private:
    OutputFile trajectory_;
    OutputFile covariance_;
    OutputFile frames_;
};

/** The point of a landmark, if there is one: for inverse depth rho and rho - 2 sigma are positive.
 *  Its covariance by first-order propagation. */
struct LandmarkPoint
{
    Eigen::Vector3d p;
    Eigen::Matrix3d P;
};
[[nodiscard]] MONOSLAM_SLAM_EXPORT std::optional<LandmarkPoint> pointOf(
    const MapLandmark& landmark);

/** map.csv: every landmark's numbers, the frame and pixel of its appearance, and the upper triangle of
 *  its covariance, row by row. */
MONOSLAM_SLAM_EXPORT void writeMapCsv(const std::string& folder,
                                      const std::vector<MapLandmark>& map);

/** map.ply: the landmarks that have a point, with the root of the largest variance. */
MONOSLAM_SLAM_EXPORT void writeMapPly(const std::string& folder,
                                      const std::vector<MapLandmark>& map);
}  // namespace monoslam
