// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/TCamera.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_mrpt/export.h"
#include "monoslam_mrpt/timestamps.h"

namespace monoslam
{
struct RawlogWriterOptions
{
    std::string file;    ///< ends in .rawlog
    bool embed = false;  ///< images inside the file, grey, not compressed
    bool force = false;  ///< replace an existing file and its images
    mrpt::img::TCamera camera;
    mrpt::poses::CPose3D cameraPose;  ///< on the vehicle
    std::string sensorLabel = "camera";
};

/** Images and truth as an observation-only rawlog of stock MRPT classes, or features in the place of
 *  images, which are a class of ours (CObservationPixelFeatures).
 *
 * Images lie in FILE_Images/ unless they are embedded. A failure leaves no rawlog behind. */
class MONOSLAM_MRPT_EXPORT RawlogWriter
{
   public:
    /** \throw std::runtime_error if the file exists and force is not set, or cannot be written */
    explicit RawlogWriter(RawlogWriterOptions options);
    ~RawlogWriter();
    RawlogWriter(const RawlogWriter&) = delete;
    RawlogWriter& operator=(const RawlogWriter&) = delete;

    /** Copies a JPEG or PNG as it is; converts any other format to PNG.
     *  \throw std::runtime_error if it cannot be decoded or is not of the camera's size */
    void addImageFile(Ticks t, const std::string& file);

    /** Pixels of CV_8UC1 or CV_8UC3, stored as PNG. */
    void addImage(Ticks t, const cv::Mat& pixels);

    /** A frame without image. */
    void addFeatures(Ticks t, std::vector<PixelFeature> features);

    /** T_world_camera, as a CObservationRobotPose labelled GT. */
    void addTruth(Ticks t, const mrpt::poses::CPose3D& T_world_camera);

    /** Completes the file and reads it back. \throw std::runtime_error if it is incomplete */
    void close();

   private:
    std::string nextImageName(const std::string& extension);
    void checkSize(const cv::Mat& pixels, const std::string& what) const;
    void removeOldImages() const;
    void write(mrpt::obs::CObservation& observation, Ticks t);
    void writeImage(Ticks t, const std::string& externalName, const cv::Mat& pixels);

    RawlogWriterOptions options_;
    std::string imagesFolder_;
    mrpt::io::CFileGZOutputStream stream_;
    long images_ = 0;
    long featureFrames_ = 0;
    long truths_ = 0;
    bool complete_ = false;
};
}  // namespace monoslam
