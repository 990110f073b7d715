// SPDX-License-Identifier: BSD-3-Clause
#include "JobRecord.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "lastLine.h"
#include "writeDurably.h"

namespace monoslam
{
using nlohmann::ordered_json;

namespace
{
ordered_json readJson(const std::string& path)
{
    std::ifstream file(path);
    ordered_json json = ordered_json::parse(file, nullptr, false);
    if (json.is_discarded()) throw std::runtime_error(path + ": missing or damaged");
    return json;
}

/** Numbers and flags of the summary by their path; its times and what they share in last. */
void addSummary(const ordered_json& summary, ordered_json& figures)
{
    for (const auto& [key, value] : summary.items())
        if (!value.is_structured() && key != "seed") figures["run_" + key] = value;
    for (const char* group : {"totals", "map"})
        for (const auto& [key, value] : summary.at(group).items())
            figures[std::string("run_") + group + "_" + key] = value;
    std::string notes;
    for (const auto& note : summary.at("notes"))
        notes += (notes.empty() ? "" : "; ") + note.get<std::string>();
    figures["run_notes"] = notes;
    for (const auto& [stage, times] : summary.at("times").items())
        for (const auto& [key, value] : times.items()) figures["time_" + stage + "_" + key] = value;
}
}  // namespace

std::optional<JobRecord> readRecord(const std::string& folder)
{
    const std::string path = folder + "/" + kRecordFile;
    if (!std::filesystem::exists(path)) return std::nullopt;
    try
    {
        const ordered_json json = readJson(path);
        JobRecord record;
        record.done = json.at("done").get<bool>();
        record.status = json.at("status").get<int>();
        record.error = json.at("error").get<std::string>();
        if (!json.at("wall_s").is_null()) record.wall_s = json.at("wall_s").get<double>();
        record.figures = json.at("figures");
        return record;
    }
    catch (const std::exception&)
    {
        return std::nullopt;  // not what we write: the job has to run again
    }
}

void writeRecord(const std::string& folder, const JobRecord& record)
{
    ordered_json json;
    json["done"] = record.done;
    json["status"] = record.status;
    json["error"] = record.error;
    json["wall_s"] = record.wall_s ? ordered_json(*record.wall_s) : ordered_json();
    json["figures"] = record.figures;
    std::filesystem::create_directories(folder);
    syncFolder(folder);
    const auto replace = ordered_json::error_handler_t::replace;  // a log may hold any bytes
    writeDurably(folder + "/" + kRecordFile, json.dump(1, ' ', false, replace) + "\n");
}

JobRecord recordOf(const std::string& folder, bool evaluated)
{
    JobRecord record;
    record.done = true;
    if (evaluated)
    {
        const ordered_json runs = readJson(folder + "/" + kFiguresFile);
        for (const auto& [key, value] : runs.at(0).items())
            if (key != "name") record.figures[key] = value;
    }
    addSummary(readJson(folder + "/summary.json"), record.figures);
    return record;
}

JobRecord failureOf(const std::string& folder, int status)
{
    JobRecord record;
    record.status = status;
    record.error = lastLineOf(folder + "/" + kLogFile);
    if (status > 128)
        record.error = "ended by signal " + std::to_string(status - 128) +
                       (record.error.empty() ? "" : " after: ") + record.error;
    return record;
}
}  // namespace monoslam
