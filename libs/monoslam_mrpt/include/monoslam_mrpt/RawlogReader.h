// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_mrpt/RawlogContents.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_slam/MonoSlam.h"

namespace monoslam
{
class ConfigSection;
class ObservationStream;

/** Options of ini section [rawlog]. */
struct MONOSLAM_MRPT_EXPORT RawlogOptions
{
    std::string file;          ///< relative to the ini
    std::string sensor_label;  ///< empty: the only one that bears images
    int first_frame = 0;       ///< counted over the images of that label
    int frame_count = 0;       ///< 0 = all
    int every_nth = 1;
    StereoSide stereo_side = StereoSide::Left;

    static RawlogOptions from(ConfigSection section);
};

/** Images of one sensor in a rawlog as frames of one camera.
 *
 * The file is passed over once at the start, which finds what is wrong with it before anything is
 * computed, then streamed. Frames that are missing are no error: dt is real; see gaps(). Of a
 * truncated file the frames before the damage are read, then next() throws. Only a gz file says
 * where it ends: a plain one that was cut exactly between two objects looks complete. */
class MONOSLAM_MRPT_EXPORT RawlogReader
{
   public:
    /** \throw std::runtime_error, std::invalid_argument naming file and frame: rawlog missing or
     *  damaged before its first image, without images, with several labels, time not increasing, no
     *  calibration */
    RawlogReader(RawlogOptions rawlog, CameraOptions camera);
    ~RawlogReader();
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;

    /** The next frame, or nothing at the end.
     *  \throw std::runtime_error naming file and frame: image missing, undecodable, of another
     *  size, or without calibration; at the end: damage() */
    std::optional<Frame> next();

    [[nodiscard]] const CameraParameters& camera() const { return camera_; }
    [[nodiscard]] const mrpt::poses::CPose3D& cameraPose() const { return cameraPose_; }
    [[nodiscard]] const std::string& sensorLabel() const { return rawlog_.sensor_label; }
    [[nodiscard]] long frameCount() const { return frameCount_; }  ///< that next() will yield
    [[nodiscard]] const std::vector<RecordedPose>& groundTruth() const { return groundTruth_; }

    /** What ends the file before the last frame that was asked for; empty if nothing does. */
    [[nodiscard]] const std::string& damage() const { return damage_; }

    /** One line for every hole in time of more than one and a half median steps. */
    [[nodiscard]] const std::vector<std::string>& gaps() const { return gaps_; }

   private:
    mrpt::obs::CObservation::Ptr nextImage();
    [[nodiscard]] bool isSelected(long index) const;
    void checkTimes(const std::vector<Ticks>& times);
    void findGaps(const std::vector<Ticks>& times);
    void readCamera();
    [[noreturn]] void fail(long index, const std::string& message) const;

    RawlogOptions rawlog_;
    CameraOptions cameraOptions_;
    std::unique_ptr<ObservationStream> stream_;
    std::string imagesFolder_;
    CameraParameters camera_;
    mrpt::poses::CPose3D cameraPose_;
    long frameCount_ = 0;
    long yielded_ = 0;
    long index_ = -1;
    std::string damage_;
    std::vector<RecordedPose> groundTruth_;
    std::vector<std::string> gaps_;
};
}  // namespace monoslam
