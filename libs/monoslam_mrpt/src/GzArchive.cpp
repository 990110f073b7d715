// SPDX-License-Identifier: BSD-3-Clause
#include "GzArchive.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace monoslam
{
std::string GzArchive::complaint() const
{
    int code = Z_OK;
    const std::string message = gzerror(file_.get(), &code);  // "FILE: what is wrong"
    if (code == Z_OK) return {};
    const auto colon = message.rfind(": ");
    return colon == std::string::npos ? message : message.substr(colon + 2);
}

size_t GzArchive::read(void* bytes, size_t count)
{
    constexpr size_t kMost = std::numeric_limits<int>::max();  // of one call of gzread()
    size_t done = 0;
    while (done < count)
    {
        const auto wanted = static_cast<unsigned>(std::min(count - done, kMost));
        const int got = gzread(file_.get(), static_cast<char*>(bytes) + done, wanted);
        if (got <= 0) break;  // the end or an error: complaint() tells which
        done += static_cast<size_t>(got);
    }
    bytesRead_ += done;
    return done;
}

size_t GzArchive::write(const void* /*bytes*/, size_t /*count*/)
{
    throw std::logic_error("GzArchive is for reading only");
}
}  // namespace monoslam
