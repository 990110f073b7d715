// SPDX-License-Identifier: BSD-3-Clause
#include "RunOutput.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;

/** Cells of a CSV line; a quoted one may hold commas. */
std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line)
    {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else if (c != '\r')
            cells.back() += c;
    }
    return cells;
}

std::size_t columnOf(const std::vector<std::string>& header, const std::string& name)
{
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
}

FrameLog readFrameLog(const std::string& fileName)
{
    std::ifstream file(fileName);
    std::string line;
    if (!std::getline(file, line)) throw std::invalid_argument(fileName + ": cannot be read");
    const std::vector<std::string> header = split(line);
    const std::size_t state = columnOf(header, "state");
    const std::size_t total_ms = columnOf(header, "total_ms");
    FrameLog log;
    while (std::getline(file, line))
    {
        const std::vector<std::string> cells = split(line);
        ++log.frames;
        if (state < cells.size() && cells[state] == "lost") ++log.lost;
        if (state < cells.size() && cells[state] == "degraded") ++log.degraded;
        if (total_ms < cells.size()) log.total_ms.push_back(std::stod(cells[total_ms]));
    }
    return log;
}
}  // namespace

RunOutput readRun(const std::string& path)
{
    RunOutput run;
    if (!fs::is_directory(path))
    {
        run.name = fs::path(path).filename().string();
        run.trajectory = readTum(path);
        return run;
    }
    const fs::path folder(path);
    run.name = (folder / ".").lexically_normal().parent_path().filename().string();
    if (run.name.empty() || run.name == "." || run.name == "..") run.name = path;
    run.trajectory = readTum((folder / "trajectory.tum").string());
    const fs::path covariances = folder / "covariance.csv";
    if (fs::exists(covariances)) run.covariances = readCovariances(covariances.string());
    const fs::path frames = folder / "frames.csv";
    if (fs::exists(frames)) run.log = readFrameLog(frames.string());
    return run;
}
}  // namespace monoslam
