// SPDX-License-Identifier: BSD-3-Clause
#include "Sequence.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "readSettings.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
constexpr const char* kWildcards = "*?[";

std::vector<std::string> filesLike(const std::string& pattern)
{
    glob_t found{};
    std::vector<std::string> files;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
        files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    return files;
}

/** What a path has from the folder of the pattern's first wildcard on, as one word. */
std::string nameWithin(const std::string& pattern, const std::string& file)
{
    const auto slash = pattern.rfind('/', pattern.find_first_of(kWildcards));
    std::string name = fs::path(file.substr(slash + 1)).replace_extension().string();
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

void replaceAll(std::string& text, const std::string& what, const std::string& by)
{
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/** The path that a key names, with {folder} and {stem} of the rawlog put in. */
std::string pathOf(ConfigSection& section, const std::string& key, const fs::path& rawlog,
                   const std::string& folder)
{
    std::string name = section.get(key, "");
    if (name.empty()) return name;
    replaceAll(name, "{folder}", rawlog.parent_path().string());
    replaceAll(name, "{stem}", rawlog.stem().string());
    return (fs::path(folder) / name).lexically_normal().string();
}

std::string fileOf(ConfigSection& section, const std::string& key, const fs::path& rawlog,
                   const std::string& folder)
{
    std::string file = pathOf(section, key, rawlog, folder);
    if (!file.empty() && !fs::is_regular_file(file)) section.fail(key, file + ": no such file");
    return file;
}

/** How the runs are judged. */
void readEvaluation(ConfigSection& section, const std::string& folder, Sequence& s)
{
    s.truth = fileOf(section, "truth", s.rawlog, folder);
    s.depth = pathOf(section, "depth", s.rawlog, folder);
    s.camera = fileOf(section, "camera", s.rawlog, folder);
    s.alignment = section.get("alignment", "SE3");
    if (s.alignment != "none" && s.alignment != "SE3" && s.alignment != "Sim3")
        section.fail("alignment", "unknown: " + s.alignment + "; known: none SE3 Sim3");
    if (!s.depth.empty() && !fs::is_directory(s.depth))
        section.fail("depth", s.depth + ": no such folder");
    if (s.outAndBack && !s.truth.empty())
        section.fail("truth", "not with out_and_back, which is evaluated without");
    if (s.truth.empty() && !s.depth.empty()) section.fail("depth", "needs truth");
    if (s.depth.empty() && !s.camera.empty()) section.fail("camera", "needs depth");
}

/** A folder's name, and the names and sizes of its files, stand for their content. */
std::string listingOf(const std::string& folder)
{
    std::vector<std::string> lines;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file())
            lines.push_back(entry.path().filename().string() + " " +
                            std::to_string(entry.file_size()));
    std::sort(lines.begin(), lines.end());
    std::string text = "depth\n";
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::string contentOf(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return std::to_string(text.str().size()) + "\n" + text.str();
}

/** Name, size and time of the last change stand for the content of a rawlog, which may have
 *  gigabytes. */
std::string fingerprintOf(const Sequence& sequence, const std::string& folder)
{
    const auto changed = fs::last_write_time(sequence.rawlog).time_since_epoch().count();
    return fs::path(sequence.rawlog).lexically_relative(folder).string() + "\n" +
           std::to_string(fs::file_size(sequence.rawlog)) + " " + std::to_string(changed) + "\n" +
           contentOf(sequence.config) + (sequence.truth.empty() ? "" : contentOf(sequence.truth)) +
           (sequence.outAndBack ? "out and back\n" : "") +
           (sequence.depth.empty() ? "" : listingOf(sequence.depth)) +
           (sequence.camera.empty() ? "" : contentOf(sequence.camera)) + sequence.alignment + "\n";
}
}  // namespace

std::vector<Sequence> readSequences(ConfigSection section, const std::string& folder)
{
    const std::string name = section.name().substr(section.name().find('.') + 1);
    const std::string written = section.get("rawlog", "");
    if (written.empty()) section.fail("rawlog", "not given, but needed");
    const std::string pattern = (fs::path(folder) / written).lexically_normal().string();
    const bool several = written.find_first_of(kWildcards) != std::string::npos;
    const auto files = several ? filesLike(pattern) : std::vector<std::string>{pattern};
    if (files.empty()) section.fail("rawlog", "no file matches " + pattern);

    Sequence common;
    common.section = section.name();
    common.settings = readSettings(section);
    common.outAndBack = section.get("out_and_back", false);
    std::vector<Sequence> sequences;
    for (const std::string& file : files)
    {
        Sequence& s = sequences.emplace_back(common);
        s.name = several ? name + "." + nameWithin(pattern, file) : name;
        if (!fs::is_regular_file(file)) section.fail("rawlog", file + ": no such file");
        s.rawlog = file;
        s.config = fileOf(section, "config", file, folder);
        readEvaluation(section, folder, s);
        if (s.config.empty()) section.fail("config", "not given, but needed");
        s.fingerprint = fingerprintOf(s, folder);
    }
    section.rejectUnknownKeys();
    return sequences;
}
}  // namespace monoslam
