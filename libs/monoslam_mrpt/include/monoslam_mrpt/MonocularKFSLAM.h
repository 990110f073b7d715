// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/CLandmark.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DQuatPDFGaussian.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_mrpt/export.h"
#include "monoslam_mrpt/imageOf.h"
#include "monoslam_slam/MonoSlam.h"

namespace monoslam
{
/** The monocular filter in the manner of mrpt::slam::CRangeBearingKFSLAM: MRPT's observations in,
 *  MRPT's poses, points and matrices out.
 *
 * \code
 *      MonocularKFSLAM slam;
 *      slam.loadOptions(mrpt::config::CConfigFile("config/default.ini"));
 *      for (const auto& observation : rawlog) slam.processObservation(observation);
 *      slam.getCurrentState(pose, points, ids, x, P);
 * \endcode */
class MONOSLAM_MRPT_EXPORT MonocularKFSLAM
{
   public:
    explicit MonocularKFSLAM(unsigned seed = 1);
    ~MonocularKFSLAM();
    MonocularKFSLAM(const MonocularKFSLAM&) = delete;
    MonocularKFSLAM& operator=(const MonocularKFSLAM&) = delete;

    /** The sections of config/default.ini but [rawlog] and [output]; empties the map.
     *  \param fileName  for messages \throw std::invalid_argument naming section and key */
    void loadOptions(const mrpt::config::CConfigFileBase& ini, const std::string& fileName = {});

    /** Empties the map and forgets the camera; options stay. */
    void reset();

    /** An image of the moving camera, embedded or stored outside, then below
     *  mrpt::img::CImage::getImagesPathBase(). The first one decides the calibration, if the
     *  options do not.
     *  \return nothing if the observation is no image
     *  \throw std::invalid_argument without calibration, if time does not increase, or on an image
     *         of another size; std::runtime_error if it cannot be decoded */
    std::optional<FrameReport> processObservation(const mrpt::obs::CObservation::Ptr& observation);

    /** False before the first image, and while a metric start waits for its target. */
    [[nodiscard]] bool hasPose() const;

    /** The camera's pose in the world and its 7 x 7 covariance. \throw std::logic_error without one */
    void getCurrentCameraPose(mrpt::poses::CPose3DQuatPDFGaussian& pose) const;

    /** \param pose  of the camera
     *  \param landmarks  those that have a point: inverse depth of two sigma may reach infinity
     *  \param ids  of the entries of landmarks
     *  \param x, P  the whole state: camera (r, q, v, omega: 13 numbers), then clones and landmarks
     *  \throw std::logic_error without a pose */
    void getCurrentState(mrpt::poses::CPose3DQuatPDFGaussian& pose,
                         std::vector<mrpt::math::TPoint3D>& landmarks,
                         std::map<unsigned int, mrpt::maps::CLandmark::TLandmarkID>& ids,
                         mrpt::math::CVectorDouble& x, mrpt::math::CMatrixDouble& P) const;
    /** The same with yaw, pitch and roll. */
    void getCurrentState(mrpt::poses::CPose3DPDFGaussian& pose,
                         std::vector<mrpt::math::TPoint3D>& landmarks,
                         std::map<unsigned int, mrpt::maps::CLandmark::TLandmarkID>& ids,
                         mrpt::math::CVectorDouble& x, mrpt::math::CMatrixDouble& P) const;

    /** Path, camera, landmarks and their ellipsoids, instead of what the set holds. */
    void getAs3DObject(mrpt::opengl::CSetOfObjects::Ptr& objects) const;

   private:
    struct Options;
    void begin(const RecordedImage& recorded);

    unsigned seed_;
    std::unique_ptr<Options> options_;
    std::unique_ptr<MonoSlam> slam_;
    std::vector<Vector7d> path_;
    long frames_ = 0;
    bool hasPose_ = false;
};
}  // namespace monoslam
