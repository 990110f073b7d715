// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <random>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/RecordedFrame.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/FrameReport.h"
#include "monoslam_slam/MonoSlamOptions.h"
#include "monoslam_slam/export.h"

namespace monoslam
{
/** One image of the moving camera: 8-bit grey, of the camera's size. */
struct Frame
{
    double t_s = 0.0;  ///< [s], increasing
    cv::Mat image;     ///< CV_8UC1
    long index = 0;    ///< number in the recording
};

/** Is told of the association problem of a frame before it is solved. problem() searches the image
 *  once more for all that is recorded, and changes nothing of the run. */
using ProblemObserver =
    std::function<void(long frame, const std::function<RecordedFrame()>& problem)>;

/** Monocular EKF-SLAM: frames in, belief out.
 *
 * Each frame: predict, search and associate and update (the Associator), then map management.
 * The world is the target's for a metric start, else the first camera's with the median depth of
 * the first landmarks as its unit. */
class MONOSLAM_SLAM_EXPORT MonoSlam
{
   public:
    MonoSlam(MonoSlamOptions options, const Camera& camera, std::unique_ptr<Associator> associator,
             unsigned seed, FilterEngine engine = {});
    ~MonoSlam();
    MonoSlam(MonoSlam&&) noexcept;
    MonoSlam& operator=(MonoSlam&&) noexcept;
    MonoSlam(const MonoSlam&) = delete;
    MonoSlam& operator=(const MonoSlam&) = delete;

    /** \throw std::invalid_argument on an image of the wrong size or type, or time not increasing */
    FrameReport process(const Frame& frame);

    /** From the next frame on; an empty one ends it. */
    void observeProblems(ProblemObserver observer);

    [[nodiscard]] const Mixture& mixture() const;
    [[nodiscard]] std::vector<MapLandmark> map() const;
    [[nodiscard]] const Camera& camera() const;

   private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};
}  // namespace monoslam
