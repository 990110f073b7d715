// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation.h>

#include <deque>
#include <string>

#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** The observations of a rawlog one by one, of either format, gz or plain, never all in memory.
 *
 * MRPT's own loop ends silently at a damaged object; this one throws std::runtime_error, naming the
 * file and the number of objects read before it. */
class MONOSLAM_MRPT_EXPORT ObservationStream
{
   public:
    explicit ObservationStream(const std::string& file);

    /** \return null at the end of the file */
    mrpt::obs::CObservation::Ptr next();

   private:
    mrpt::serialization::CSerializable::Ptr readObject();

    std::string file_;
    mrpt::io::CFileGZInputStream stream_;
    std::deque<mrpt::obs::CObservation::Ptr> pending_;
    long objects_ = 0;
};
}  // namespace monoslam
