// SPDX-License-Identifier: BSD-3-Clause
#include "splitWords.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace monoslam
{
std::vector<std::string> splitWords(std::string text)
{
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}
}  // namespace monoslam
