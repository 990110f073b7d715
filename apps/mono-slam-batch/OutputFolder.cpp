// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFolder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
constexpr const char* kLockFile = ".mono-slam-batch.lock";  // also says whose folder it is
constexpr auto kRetryInterval = std::chrono::milliseconds(20);

void check(const std::string& path, bool force)
{
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed) throw std::runtime_error(path + ": cannot be created: " + failed.message());
    if (!force && !fs::is_empty(path) && !fs::exists(path + "/" + kLockFile))
        throw std::runtime_error(path +
                                 ": the output folder is not empty and not of a batch; use "
                                 "--force to add the files of this batch");
}

/** Programs of a batch that was killed inherit the lock and hold it until they have died as well,
 *  so that no two of them write to one folder. That takes moments. */
bool waitForLock(int file, std::chrono::milliseconds patience)
{
    const auto end = std::chrono::steady_clock::now() + patience;
    while (flock(file, LOCK_EX | LOCK_NB) != 0)
    {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(kRetryInterval);
    }
    return true;
}
}  // namespace

OutputFolder::OutputFolder(const std::string& path, bool force, std::chrono::milliseconds patience)
    : lock_(-1)
{
    check(path, force);
    lock_ = open((path + "/" + kLockFile).c_str(), O_RDWR | O_CREAT, 0666);  // inherited
    if (lock_ < 0) throw std::runtime_error(path + ": cannot be used: " + std::strerror(errno));
    if (waitForLock(lock_, patience)) return;
    close(lock_);
    throw std::runtime_error(path + ": another batch is running in this folder");
}

OutputFolder::~OutputFolder()
{
    close(lock_);
}
}  // namespace monoslam
