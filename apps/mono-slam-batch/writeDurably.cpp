// SPDX-License-Identifier: BSD-3-Clause
#include "writeDurably.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
[[noreturn]] void fail(const std::string& path, const std::string& what)
{
    throw std::runtime_error(path + ": cannot be " + what + ": " + std::strerror(errno));
}

void sync(const std::string& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) fail(path, "opened");
    const bool synced = fsync(file) == 0;
    close(file);
    if (!synced) fail(path, "written");
}
}  // namespace

void writeDurably(const std::string& path, const std::string& text)
{
    const std::string part = path + ".part";
    std::FILE* file = std::fopen(part.c_str(), "we");
    if (file == nullptr) fail(path, "written");
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                         std::fflush(file) == 0 && fsync(fileno(file)) == 0;
    if (std::fclose(file) != 0 || !written)
    {
        const int why = errno;
        std::remove(part.c_str());  // where the disk is full, room is what is wanted
        errno = why;
        fail(path, "written");
    }
    if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, "replaced");
    sync(fs::path(path).parent_path().string());  // the new name as well
}

void syncFolder(const std::string& folder)
{
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) sync(entry.path().string());
}
}  // namespace monoslam
