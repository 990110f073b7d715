// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "monoslam_support/readIni.h"

namespace monoslam
{
using mrpt::config::CConfigFileMemory;

namespace
{
constexpr const char* kSection = "association";
constexpr std::string_view kStrategy = "association.";
/** CPU time of MRPT's JCBB for one problem [s], unless the options say otherwise. */
constexpr const char* kMrptCap_s = "0.05";

void setDefault(CConfigFileMemory& ini, const std::string& section, const std::string& key,
                const std::string& value)
{
    if (!ini.keyExists(section, key)) ini.write(section, key, value);
}

/** Begins as the section of a strategy, or a setting of [association...], does. */
bool isOfStrategy(const std::string& name)
{
    return name.compare(0, kStrategy.size(), kStrategy) == 0;
}

/** Misspelt sections would be ignored otherwise; the other sections are mono-slam's. */
void rejectUnknownSections(const CConfigFileMemory& ini, const std::string& fileName)
{
    const std::vector<std::string> names = associatorNames();
    std::vector<std::string> sections;
    ini.getAllSections(sections);
    for (const std::string& section : sections)
    {
        if (!isOfStrategy(section)) continue;
        const std::string name = section.substr(kStrategy.size());
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw std::invalid_argument(
                std::string(fileName).append(": unknown section [").append(section).append("]"));
    }
}

void rejectOtherSettings(const std::vector<std::string>& settings)
{
    for (const std::string& setting : settings)
        if (!isOfStrategy(setting))
            throw std::invalid_argument("--set " + setting + ": only [association...] is read");
}

/** Keys max_candidates are known by those that take them. */
bool takesSeveral(const std::string& name)
{
    try
    {
        CConfigFileMemory ini;
        ini.write("association." + name, "max_candidates", "1");
        return makeAssociator(name, ini) != nullptr;
    }
    catch (const std::invalid_argument&)
    {
        return false;
    }
}
}  // namespace

Strategies::Strategies(const Arguments& arguments)
    : fileName_(arguments.configFile.empty() ? "command line" : arguments.configFile),
      names_(arguments.strategies.empty() ? associatorNames() : arguments.strategies)
{
    CConfigFileMemory ini;
    rejectOtherSettings(arguments.settings);
    if (arguments.configFile.empty())
        applySettings(arguments.settings, ini);
    else
        readIni(arguments.configFile, arguments.settings, ini);
    rejectUnknownSections(ini, fileName_);
    for (const std::string& name : associatorNames())
        if (ini.sectionExists("association." + name))
            static_cast<void>(makeAssociator(name, ini, fileName_));
    if (std::find(names_.begin(), names_.end(), "jcbb_mrpt") != names_.end())
        setDefault(ini, "association.jcbb_mrpt", "time_cap_s", kMrptCap_s);
    ini.getContent(ini_);
    static_cast<void>(make());
}

std::vector<NamedAssociator> Strategies::make(const CConfigFileMemory& ini) const
{
    std::vector<NamedAssociator> made;
    for (const std::string& name : names_)
        made.push_back({name, makeAssociator(name, ini, fileName_)});
    return made;
}

std::vector<NamedAssociator> Strategies::make() const
{
    return make(CConfigFileMemory(ini_));
}

std::vector<NamedAssociator> Strategies::makeFor(int landmarks, int candidates) const
{
    CConfigFileMemory ini(ini_);
    setDefault(ini, kSection, "first_stage_landmarks", "0");
    setDefault(ini, kSection, "max_iterations", "1");
    setDefault(ini, kSection, "max_measured", std::to_string(landmarks));
    for (const std::string& name : names_)
        if (takesSeveral(name))
            setDefault(ini, "association." + name, "max_candidates", std::to_string(candidates));
    return make(ini);
}
}  // namespace monoslam
