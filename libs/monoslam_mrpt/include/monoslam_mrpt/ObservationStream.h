// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>

#include <deque>
#include <string>

#include "monoslam_mrpt/RawlogObjectStream.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** The observations of a rawlog one by one, of either format, gz or plain, never all in memory.
 *  \throw std::runtime_error as RawlogObjectStream does */
class MONOSLAM_MRPT_EXPORT ObservationStream
{
   public:
    explicit ObservationStream(const std::string& file);

    /** \return null at the end of the file */
    mrpt::obs::CObservation::Ptr next();

   private:
    RawlogObjectStream objects_;
    std::deque<mrpt::obs::CObservation::Ptr> pending_;
};
}  // namespace monoslam
