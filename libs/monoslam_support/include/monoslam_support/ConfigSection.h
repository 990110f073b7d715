// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileBase.h>

#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "monoslam_support/export.h"

namespace monoslam
{
/** Closed interval that a number of an ini file must lie in. */
struct Range
{
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
};

inline constexpr Range kPositive{std::numeric_limits<double>::min(),
                                 std::numeric_limits<double>::max()};

/** One section of an ini file, which remembers the keys that were read.
 *
 * MRPT's reader keeps the default for a misspelt key and reads "abc" as 0; this one throws
 * std::invalid_argument, naming file, section, key and value, for an ill-typed value, a value
 * out of range and, in rejectUnknownKeys(), for every key that nobody asked for.
 */
class MONOSLAM_SUPPORT_EXPORT ConfigSection
{
   public:
    ConfigSection(const mrpt::config::CConfigFileBase& file, std::string section,
                  std::string fileName = {});

    [[nodiscard]] double get(const std::string& key, double fallback, Range range = {});
    [[nodiscard]] int get(const std::string& key, int fallback, Range range = {});
    [[nodiscard]] bool get(const std::string& key, bool fallback);
    [[nodiscard]] std::string get(const std::string& key, const std::string& fallback);
    [[nodiscard]] std::string get(const std::string& key, const char* fallback);
    [[nodiscard]] std::vector<double> get(const std::string& key, std::vector<double> fallback);

    /** One of the named values; anything else throws and lists the names. */
    template <typename Enum>
    [[nodiscard]] Enum get(const std::string& key, Enum fallback,
                           const std::vector<std::pair<std::string, Enum>>& names)
    {
        std::vector<std::string> known;
        for (const auto& entry : names) known.push_back(entry.first);
        std::string chosen;
        for (const auto& entry : names)
            if (entry.second == fallback) chosen = entry.first;
        chosen = getOneOf(key, chosen, known);
        for (const auto& entry : names)
            if (entry.first == chosen) return entry.second;
        return fallback;
    }

    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] const std::string& name() const { return section_; }

    /** All keys of the section as they are written, asked for or not. */
    [[nodiscard]] std::vector<std::string> keys() const;

    /** \throw std::invalid_argument naming every key of the section that no get() asked for. */
    void rejectUnknownKeys() const;

    /** Throws std::invalid_argument "file: [section] key = value: message". */
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;

   private:
    [[nodiscard]] std::string getOneOf(const std::string& key, const std::string& fallback,
                                       const std::vector<std::string>& known);
    [[nodiscard]] std::string raw(const std::string& key, bool& found);

    const mrpt::config::CConfigFileBase& file_;
    std::string section_;
    std::string fileName_;
    std::set<std::string> asked_;
};
}  // namespace monoslam
