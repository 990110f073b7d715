// SPDX-License-Identifier: BSD-3-Clause
#include "checkJobs.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "ProcessPool.h"
#include "lastLine.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
/** A folder for what the checks print. */
class ScratchFolder
{
   public:
    ScratchFolder()
    {
        std::string pattern = (fs::temp_directory_path() / "mono-slam-batch-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error(pattern + ": cannot be created");
        path_ = pattern;
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

   private:
    std::string path_;
};
}  // namespace

void checkJobs(const std::vector<Job>& jobs, const std::string& programs, std::size_t slots)
{
    const ScratchFolder scratch;
    const auto logOf = [&](std::size_t i) { return scratch.path() + "/" + std::to_string(i); };
    std::set<std::string> origins;
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < jobs.size(); ++i)
        if (origins.insert(jobs[i].origin).second)
            tasks.push_back({i, {checkOf(jobs[i], programs, scratch.path())}, logOf(i)});
    std::map<std::size_t, std::string> refused;
    runTasks(std::move(tasks), slots,
             [&](const std::vector<TaskEnd>& ended, std::size_t)
             {
                 for (const TaskEnd& end : ended)
                     if (end.status != 0) refused[end.id] = lastLineOf(logOf(end.id));
             });
    if (refused.empty()) return;
    const auto& [job, why] = *refused.begin();
    std::string message = jobs[job].origin + ": " + why;
    if (refused.size() > 1)
        message += " (and " + std::to_string(refused.size() - 1) + " more are refused)";
    throw std::invalid_argument(message);
}
}  // namespace monoslam
