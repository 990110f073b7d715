// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RawlogObjectStream.h"

#include <filesystem>
#include <stdexcept>

#include "GzArchive.h"
#include "monoslam_mrpt/registerAllClasses.h"

namespace monoslam
{
using mrpt::serialization::CSerializable;

namespace
{
/** The first line of an MRPT exception that says something, without its stack trace. */
std::string essence(const std::exception& error)
{
    const std::string text = error.what();
    const std::string head = "Message:";
    auto begin = text.find(head);
    begin = begin == std::string::npos ? 0 : begin + head.size();
    begin = text.find_first_not_of(" \n", begin);
    if (begin == std::string::npos) return "unknown error";
    return text.substr(begin, text.find('\n', begin) - begin);
}
}  // namespace

RawlogObjectStream::RawlogObjectStream(const std::string& file) : file_(file)
{
    registerAllClasses();
    if (!std::filesystem::exists(file)) throw std::runtime_error(file + ": no such rawlog");
    if (std::filesystem::is_regular_file(file)) archive_ = std::make_unique<GzArchive>(file);
    if (!archive_ || !archive_->isOpen())
        throw std::runtime_error(file + ": cannot be read as a rawlog");
}

RawlogObjectStream::~RawlogObjectStream() = default;

void RawlogObjectStream::failAfterObjects(const std::string& why) const
{
    if (objects_ == 0) throw std::runtime_error(file_ + ": not a rawlog (" + why + ")");
    throw std::runtime_error(file_ + ": truncated or damaged after " + std::to_string(objects_) +
                             " objects (" + why + ")");
}

CSerializable::Ptr RawlogObjectStream::next()
{
    const std::uint64_t begin = archive_->bytesRead();
    try
    {
        auto object = archive_->ReadObject();
        ++objects_;
        return object;
    }
    catch (const mrpt::serialization::CExceptionEOF&)
    {
        if (const std::string why = archive_->complaint(); !why.empty()) failAfterObjects(why);
        // MRPT says end of file wherever an object's header is cut.
        if (archive_->bytesRead() != begin) failAfterObjects("the file ends within an object");
        return nullptr;
    }
    catch (const std::exception& e)
    {
        const std::string why = archive_->complaint();
        failAfterObjects(why.empty() ? essence(e) : why);
    }
}
}  // namespace monoslam
