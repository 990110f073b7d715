// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "monoslam_support/readIni.h"
#include "parseSeeds.h"
#include "readSettings.h"
#include "splitWords.h"

namespace monoslam
{
namespace fs = std::filesystem;
using mrpt::config::CConfigFileMemory;
using Words = std::vector<std::string>;

namespace
{
bool contains(const Words& words, const std::string& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/** Names become folders, so they have no slash, no space and no dot in front. */
bool isName(const std::string& text)
{
    const auto isAllowed = [](unsigned char c)
    { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '+'; };
    return !text.empty() && text.front() != '.' && std::all_of(text.begin(), text.end(), isAllowed);
}

/** NAME of all sections [kind.NAME]. */
Words namesOf(const CConfigFileMemory& ini, const std::string& kind)
{
    Words sections, names;
    ini.getAllSections(sections);
    for (const std::string& section : sections)
        if (section.compare(0, kind.size() + 1, kind + ".") == 0)
            names.push_back(section.substr(kind.size() + 1));
    return names;
}

[[noreturn]] void rejectSection(const std::string& fileName, const std::string& section,
                                const std::string& why)
{
    throw std::invalid_argument(fileName + ": [" + section + "]: " + why);
}

void checkSections(const CConfigFileMemory& ini, const std::string& fileName)
{
    Words sections;
    ini.getAllSections(sections);
    for (const std::string& section : sections)
    {
        const auto dot = section.find('.');
        const std::string kind = section.substr(0, dot);
        if (section == "batch") continue;
        if (dot == std::string::npos || (kind != "sequence" && kind != "variant"))
            rejectSection(fileName, section,
                          "unknown section; known: batch sequence.NAME variant.NAME");
        if (!isName(section.substr(dot + 1)))
            rejectSection(fileName, section, "a name has letters, digits and _ - . + only");
    }
}

[[noreturn]] void rejectWord(const ConfigSection& section, const std::string& key,
                             const std::string& word, const Words& known)
{
    std::string message = "unknown: " + word + "; known:";
    for (const std::string& name : known) message.append(" ").append(name);
    section.fail(key, message);
}

[[noreturn]] void rejectName(const Batch& batch, const Sequence& sequence, const std::string& why)
{
    throw std::invalid_argument(batch.fileName + ": [" + sequence.section + "] rawlog: " +
                                sequence.rawlog + ": its name " + sequence.name + " " + why);
}

/** Words of a key, each among those that exist and once; all of them without the key. */
Words wordsOf(ConfigSection& section, const std::string& key, const Words& known)
{
    Words words = splitWords(section.get(key, ""));
    if (!section.has(key)) return known;
    if (words.empty()) section.fail(key, "names nothing");
    for (const std::string& word : words)
    {
        if (!contains(known, word)) rejectWord(section, key, word, known);
        if (std::count(words.begin(), words.end(), word) > 1)
            section.fail(key, word + " comes twice");
    }
    return words;
}

Variant readVariant(ConfigSection section, const std::string& name, const Words& strategies)
{
    Variant variant{name, readSettings(section), wordsOf(section, "strategies", strategies)};
    section.rejectUnknownKeys();
    return variant;
}

void rejectEqualNames(const Batch& batch)
{
    std::set<std::string> names;
    for (const Sequence& sequence : batch.sequences)
    {
        if (!isName(sequence.name))
            rejectName(batch, sequence, "has other than letters, digits and _ - . +");
        if (!names.insert(sequence.name).second)
            rejectName(batch, sequence, "is that of another sequence");
    }
}
}  // namespace

Batch readBatch(const std::string& fileName, const Words& strategies)
{
    CConfigFileMemory ini;
    readIni(fileName, {}, ini);
    checkSections(ini, fileName);
    const std::string folder = fs::absolute(fileName).parent_path().string();

    Batch batch;
    batch.fileName = fileName;
    ConfigSection section(ini, "batch", fileName);
    const std::string output = section.get("output", "");
    if (output.empty()) section.fail("output", "not given, but needed");
    batch.output = (fs::path(folder) / output).lexically_normal().string();
    batch.strategies = wordsOf(section, "strategies", strategies);
    if (!section.has("strategies")) section.fail("strategies", "not given, but needed");
    const auto seeds = parseSeeds(section.get("seeds", "1"));
    if (!seeds) section.fail("seeds", "expected numbers and ranges, each seed once: 1-20, 25");
    batch.seeds = *seeds;

    for (const auto& name : wordsOf(section, "sequences", namesOf(ini, "sequence")))
        for (auto& s : readSequences(ConfigSection(ini, "sequence." + name, fileName), folder))
            batch.sequences.push_back(std::move(s));
    if (batch.sequences.empty())
        throw std::invalid_argument(fileName + ": no section [sequence.NAME]");
    rejectEqualNames(batch);
    for (const auto& name : wordsOf(section, "variants", namesOf(ini, "variant")))
        batch.variants.push_back(
            readVariant(ConfigSection(ini, "variant." + name, fileName), name, batch.strategies));
    if (batch.variants.empty()) batch.variants.push_back({"default", {}, {}});
    section.rejectUnknownKeys();
    return batch;
}
}  // namespace monoslam
