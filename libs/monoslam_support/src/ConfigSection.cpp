// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_support/ConfigSection.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace monoslam
{
namespace
{
std::string lowerCase(std::string text)
{
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string join(const std::vector<std::string>& words)
{
    std::string joined;
    for (const std::string& word : words) joined += (joined.empty() ? "" : ", ") + word;
    return joined.empty() ? "(none)" : joined;
}

/** A value ends at a ';', '#' or "//" that stands at its beginning or behind a space. */
std::string withoutComment(std::string text)
{
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const bool begins = text[i] == ';' || text[i] == '#' || text.compare(i, 2, "//") == 0;
        if (begins && (i == 0 || std::isspace(static_cast<unsigned char>(text[i - 1]))))
            text.resize(i);
    }
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    return text;
}

/** The whole text as a number, whatever the locale of the process; no inf, no nan, no overflow. */
template <typename Number>
std::optional<Number> parse(const std::string& text)
{
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    Number number{};
    if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) return {};
    return number;
}

std::string describe(Range range)
{
    std::ostringstream text;
    text << "must be ";
    if (range.lowest == kPositive.lowest)
        text << "> 0";
    else if (std::isfinite(range.lowest))
        text << ">= " << range.lowest;
    if (range.highest < kPositive.highest)
        text << (std::isfinite(range.lowest) ? " and <= " : "<= ") << range.highest;
    return text.str();
}

bool isInside(double number, Range range)
{
    return number >= range.lowest && number <= range.highest;
}

std::optional<std::vector<double>> parseList(std::string text)
{
    const bool bracketed = text.size() >= 2 && text.front() == '[' && text.back() == ']';
    if (bracketed) text = text.substr(1, text.size() - 2);
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;)
    {
        const std::optional<double> number = parse<double>(word);
        if (!number) return {};
        numbers.push_back(*number);
    }
    if (numbers.empty() && !bracketed) return {};
    return numbers;
}
}  // namespace

ConfigSection::ConfigSection(const mrpt::config::CConfigFileBase& file, std::string section,
                             std::string fileName)
    : file_(file), section_(std::move(section)), fileName_(std::move(fileName))
{
}

double ConfigSection::get(const std::string& key, double fallback, Range range)
{
    bool found = false;
    const std::string text = raw(key, found);
    if (!found) return fallback;
    const std::optional<double> number = parse<double>(text);
    if (!number) fail(key, "expected a number");
    if (!isInside(*number, range)) fail(key, describe(range));
    return *number;
}

int ConfigSection::get(const std::string& key, int fallback, Range range)
{
    bool found = false;
    const std::string text = raw(key, found);
    if (!found) return fallback;
    const std::optional<int> number = parse<int>(text);
    if (!number) fail(key, "expected an integer");
    if (!isInside(*number, range)) fail(key, describe(range));
    return *number;
}

bool ConfigSection::get(const std::string& key, bool fallback)
{
    bool found = false;
    const std::string text = lowerCase(raw(key, found));
    if (!found) return fallback;
    if (text == "true" || text == "1" || text == "yes") return true;
    if (text == "false" || text == "0" || text == "no") return false;
    fail(key, "expected true, false, yes, no, 1 or 0");
}

std::string ConfigSection::get(const std::string& key, const std::string& fallback)
{
    bool found = false;
    const std::string text = raw(key, found);
    return found ? text : fallback;
}

std::string ConfigSection::get(const std::string& key, const char* fallback)
{
    return get(key, std::string(fallback));
}

std::vector<double> ConfigSection::get(const std::string& key, std::vector<double> fallback)
{
    bool found = false;
    const std::string text = raw(key, found);
    if (!found) return fallback;
    const std::optional<std::vector<double>> numbers = parseList(text);
    if (!numbers) fail(key, "expected numbers separated by spaces or commas");
    return *numbers;
}

bool ConfigSection::has(const std::string& key) const
{
    return file_.keyExists(section_, key);
}

std::vector<std::string> ConfigSection::keys() const
{
    std::vector<std::string> present;
    file_.getAllKeys(section_, present);
    return present;
}

void ConfigSection::rejectUnknownKeys() const
{
    std::vector<std::string> unknown;
    for (const std::string& key : keys())
        if (asked_.count(lowerCase(key)) == 0) unknown.push_back(key);
    if (unknown.empty()) return;
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    throw std::invalid_argument((fileName_.empty() ? "" : fileName_ + ": ") + "[" + section_ +
                                "]: unknown keys: " + join(unknown) +
                                "; known keys: " + join(known));
}

void ConfigSection::fail(const std::string& key, const std::string& message) const
{
    const std::string value = file_.read_string(section_, key, "");
    throw std::invalid_argument((fileName_.empty() ? "" : fileName_ + ": ") + "[" + section_ +
                                "] " + key + " = " + value + ": " + message);
}

std::string ConfigSection::getOneOf(const std::string& key, const std::string& fallback,
                                    const std::vector<std::string>& known)
{
    bool found = false;
    const std::string text = raw(key, found);
    if (!found) return fallback;
    if (std::find(known.begin(), known.end(), text) == known.end())
        fail(key, "expected one of " + join(known));
    return text;
}

std::string ConfigSection::raw(const std::string& key, bool& found)
{
    asked_.insert(lowerCase(key));
    found = has(key);
    return found ? withoutComment(file_.read_string(section_, key, "")) : std::string();
}
}  // namespace monoslam
