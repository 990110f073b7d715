// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/poses/CPose3D.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Config.h"
#include "monoslam_mrpt/RangeBearingKFSLAM.h"

namespace monoslam
{
/** A landmark of the map; z = 0 in the plane. */
struct MappedLandmark
{
    mrpt::math::TPoint3D position{};
    long id = -1;
    std::size_t serial = 0;  ///< unlike its index, the same for ever
};

/** kf-slam's filter in space or in the plane, one or several of them. */
class Filter
{
   public:
    virtual ~Filter() = default;
    virtual void process(mrpt::obs::CActionCollection::Ptr& action,
                         mrpt::obs::CSensoryFrame::Ptr& observations) = 0;

    [[nodiscard]] virtual mrpt::poses::CPose3D pose() const = 0;
    /** x y z qr qx qy qz, or x y phi. */
    [[nodiscard]] virtual mrpt::math::CVectorDouble poseVector() const = 0;
    [[nodiscard]] virtual mrpt::math::CMatrixDouble covariance() const = 0;
    [[nodiscard]] virtual std::vector<MappedLandmark> landmarks() const = 0;

    /** Serial of the landmark by index in the observation. */
    [[nodiscard]] virtual std::map<std::size_t, std::size_t> associations() const = 0;
    [[nodiscard]] virtual std::map<std::size_t, std::size_t> inserted() const = 0;
    [[nodiscard]] virtual JointAssociationCounters counters() const = 0;

    virtual void drawInto(mrpt::opengl::CSetOfObjects::Ptr& objects) const = 0;
    virtual void saveAsMatlab(const std::string& file) const = 0;
};

/** \throw std::invalid_argument naming section and key */
[[nodiscard]] std::unique_ptr<Filter> makeFilter(const Config& config);
}  // namespace monoslam
