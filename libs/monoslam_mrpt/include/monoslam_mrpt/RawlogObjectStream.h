// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <memory>
#include <string>

#include "monoslam_mrpt/export.h"

namespace monoslam
{
class GzArchive;

/** The objects of a rawlog one by one, gz or plain, never all in memory.
 *
 * MRPT's own loop ends silently at a damaged object, and where a gz stream has no trailer; this one
 * throws std::runtime_error, naming the file and the number of objects read before it. A plain file
 * that was cut exactly between two objects cannot be told from a complete one. */
class MONOSLAM_MRPT_EXPORT RawlogObjectStream
{
   public:
    explicit RawlogObjectStream(const std::string& file);
    ~RawlogObjectStream();
    RawlogObjectStream(const RawlogObjectStream&) = delete;
    RawlogObjectStream& operator=(const RawlogObjectStream&) = delete;

    /** \return null at the end of the file */
    mrpt::serialization::CSerializable::Ptr next();

   private:
    [[noreturn]] void failAfterObjects(const std::string& why) const;

    std::string file_;
    std::unique_ptr<GzArchive> archive_;
    long objects_ = 0;
};
}  // namespace monoslam
