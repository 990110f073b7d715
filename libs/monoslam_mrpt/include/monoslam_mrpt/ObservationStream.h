// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>

#include <deque>
#include <memory>
#include <string>

#include "monoslam_mrpt/export.h"

namespace monoslam
{
class GzArchive;

/** The observations of a rawlog one by one, of either format, gz or plain, never all in memory.
 *
 * MRPT's own loop ends silently at a damaged object, and where a gz stream has no trailer; this one
 * throws std::runtime_error, naming the file and the number of objects read before it. A plain file
 * that was cut exactly between two objects cannot be told from a complete one. */
class MONOSLAM_MRPT_EXPORT ObservationStream
{
   public:
    explicit ObservationStream(const std::string& file);
    ~ObservationStream();

    /** \return null at the end of the file */
    mrpt::obs::CObservation::Ptr next();

   private:
    mrpt::serialization::CSerializable::Ptr readObject();
    [[noreturn]] void failAfterObjects(const std::string& why) const;

    std::string file_;
    std::unique_ptr<GzArchive> archive_;
    std::deque<mrpt::obs::CObservation::Ptr> pending_;
    long objects_ = 0;
};
}  // namespace monoslam
