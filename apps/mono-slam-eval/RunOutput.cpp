// SPDX-License-Identifier: BSD-3-Clause
#include "RunOutput.h"

#include <cmath>
#include <filesystem>

#include "CsvFile.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;

FrameLog readFrameLog(const std::string& fileName)
{
    CsvFile file(fileName);
    FrameLog log;
    while (file.next())
    {
        ++log.frames;
        const std::string state = file.text("state");
        if (state == "lost") ++log.lost;
        if (state == "degraded") ++log.degraded;
        log.total_ms.push_back(file.number("total_ms"));
        log.t_s[std::lround(file.number("index"))] = file.number("t_s");
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
    run.folder = path;
    return run;
}

std::vector<MapRow> readMap(const std::string& folder)
{
    CsvFile file(folder + "/map.csv");
    std::vector<MapRow> rows;
    while (file.next())
    {
        MapRow& row = rows.emplace_back();
        row.bornFrame = std::lround(file.number("born_frame"));
        row.born_px = {file.number("born_u_px"), file.number("born_v_px")};
        row.known = file.text("known") == "1";
        if (!file.text("x_m").empty())
            row.p.emplace(file.number("x_m"), file.number("y_m"), file.number("z_m"));
    }
    return rows;
}
}  // namespace monoslam
