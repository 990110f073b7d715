// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/TCamera.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CSerializable.h>

#include <vector>

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** Features of one camera without their image: pixels, noise, what they look like and, if it is
 *  known, what they are. For simulations, recorded matches and benchmarks of data association.
 *
 * Stock MRPT programs read it with libmonoslam_mrpt.so loaded (rawlog-edit -p, RawLogViewer -l) and
 * refuse the rawlog without. Named in MRPT's manner, because rawlogs hold the name. */
class MONOSLAM_MRPT_EXPORT CObservationPixelFeatures : public mrpt::obs::CObservation
{
    DEFINE_SERIALIZABLE(CObservationPixelFeatures, monoslam)

   public:
    mrpt::poses::CPose3D cameraPose;  ///< on the vehicle
    mrpt::img::TCamera cameraParams;
    std::vector<PixelFeature> features;

    void getSensorPose(mrpt::poses::CPose3D& pose) const override { pose = cameraPose; }
    void setSensorPose(const mrpt::poses::CPose3D& pose) override { cameraPose = pose; }
    void getDescriptionAsText(std::ostream& text) const override;

    /** rawlog-edit --export-txt: per observation the number of features, then of each
     *  id, u, v, sigma_u, sigma_v, truth. */
    [[nodiscard]] bool exportTxtSupported() const override { return true; }
    [[nodiscard]] std::string exportTxtHeader() const override;
    [[nodiscard]] std::string exportTxtDataRow() const override;
};
}  // namespace monoslam
