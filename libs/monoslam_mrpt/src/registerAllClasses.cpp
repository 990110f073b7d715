// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/registerAllClasses.h"

#include <mrpt/core/initializer.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/rtti/CObject.h>

#include "monoslam_mrpt/CObservationPixelFeatures.h"

namespace monoslam
{
void registerAllClasses()
{
    // The linker may drop MRPT's libraries, with their registrations, if nothing refers to them.
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CActionCollection));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CActionRobotMovement2D));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CActionRobotMovement3D));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CSensoryFrame));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationBearingRange));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationImage));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationStereoImages));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservation3DRangeScan));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationRobotPose));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::obs::CObservationComment));
    mrpt::rtti::registerClass(CLASS_ID(mrpt::opengl::COpenGLScene));
    mrpt::rtti::registerClass(CLASS_ID(CObservationPixelFeatures));
}
}  // namespace monoslam

MRPT_INITIALIZER(registerMonoslamClasses)
{
    monoslam::registerAllClasses();
}
