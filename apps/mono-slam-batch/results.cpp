// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <set>

namespace monoslam
{
namespace
{
std::string field(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
    {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string field(const nlohmann::ordered_json& value)
{
    if (value.is_null()) return {};
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    return field(value.is_string() ? value.get<std::string>() : value.dump());
}

std::vector<std::string> figureNames(const JobRecords& records)
{
    std::vector<std::string> names;
    std::set<std::string> present;
    for (const auto& record : records)
    {
        if (!record) continue;
        for (const auto& figure : record->figures.items())
            if (present.insert(figure.key()).second) names.push_back(figure.key());
    }
    return names;
}

std::string rowOf(const Job& job, const std::optional<JobRecord>& record)
{
    const std::string status = !record ? "pending" : record->done ? "done" : "failed";
    const std::string wall_s =
        record && record->wall_s ? nlohmann::json(*record->wall_s).dump() : "";
    return field(job.sequence) + "," + field(job.strategy) + "," + field(job.variant) + "," +
           std::to_string(job.seed) + "," + status + "," +
           (record ? std::to_string(record->status) : "") + "," +
           (record ? field(record->error) : "") + "," + field(job.folder) + "," + wall_s;
}
}  // namespace

std::string resultsCsv(const std::vector<Job>& jobs, const JobRecords& records)
{
    const auto names = figureNames(records);
    std::string text = "sequence,strategy,variant,seed,status,exit_status,error,folder,time_wall_s";
    for (const std::string& name : names) text += "," + field(name);
    text += "\n";
    for (std::size_t i = 0; i < jobs.size(); ++i)
    {
        text += rowOf(jobs[i], records[i]);
        for (const std::string& name : names)
        {
            text += ",";
            if (!records[i]) continue;
            const auto figure = records[i]->figures.find(name);
            if (figure != records[i]->figures.end()) text += field(*figure);
        }
        text += "\n";
    }
    return text;
}
}  // namespace monoslam
