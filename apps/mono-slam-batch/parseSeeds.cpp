// SPDX-License-Identifier: BSD-3-Clause
#include "parseSeeds.h"

#include <charconv>
#include <set>

#include "splitWords.h"

namespace monoslam
{
namespace
{
constexpr unsigned kMostSeeds = 1000000;  // a range beyond is a slip of the keyboard

/** Reads a number at the front of \p text and removes it. */
std::optional<unsigned> takeNumber(std::string& text)
{
    unsigned number = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc()) return std::nullopt;
    text.erase(0, static_cast<std::size_t>(read.ptr - text.data()));
    return number;
}
}  // namespace

std::optional<std::vector<unsigned>> parseSeeds(const std::string& text)
{
    std::vector<unsigned> seeds;
    std::set<unsigned> present;
    for (std::string word : splitWords(text))
    {
        const auto first = takeNumber(word);
        auto last = first;
        if (!word.empty() && word.front() == '-')
        {
            word.erase(0, 1);
            last = takeNumber(word);
        }
        if (!first || !last || !word.empty() || *last < *first || *last - *first >= kMostSeeds)
            return std::nullopt;
        for (unsigned i = 0; i <= *last - *first; ++i)
        {
            seeds.push_back(*first + i);
            if (!present.insert(seeds.back()).second) return std::nullopt;
        }
    }
    if (seeds.empty()) return std::nullopt;
    return seeds;
}
}  // namespace monoslam
