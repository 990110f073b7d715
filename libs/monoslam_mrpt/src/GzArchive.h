// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <cstdint>
#include <memory>
#include <string>

namespace monoslam
{
/** A file of serialized objects, gz or plain, that tells the end of the file from that of its data:
 *  mrpt::io::CFileGZInputStream hides that a gz stream ends before its trailer. */
class GzArchive : public mrpt::serialization::CArchive
{
   public:
    /** isOpen() says whether that succeeded. */
    explicit GzArchive(const std::string& file) : file_(gzopen(file.c_str(), "rb")) {}

    [[nodiscard]] bool isOpen() const { return file_ != nullptr; }

    /** What is wrong with the compressed stream as far as it has been read; empty if nothing is.
     *  A plain file is never wrong. */
    [[nodiscard]] std::string complaint() const;

    [[nodiscard]] std::uint64_t bytesRead() const { return bytesRead_; }  ///< uncompressed

    std::string getArchiveDescription() const override { return "rawlog"; }

   protected:
    size_t read(void* bytes, size_t count) override;
    size_t write(const void* bytes, size_t count) override;

   private:
    struct Close
    {
        void operator()(gzFile file) const { gzclose(file); }
    };
    std::unique_ptr<gzFile_s, Close> file_;
    std::uint64_t bytesRead_ = 0;
};
}  // namespace monoslam
