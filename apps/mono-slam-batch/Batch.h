// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Sequence.h"

namespace monoslam
{
/** Overrides with a name, for all strategies or for some. */
struct Variant
{
    std::string name;
    std::vector<std::string> settings;    ///< "section.key=value"
    std::vector<std::string> strategies;  ///< empty: all
};

/** What a batch's ini says, checked; every combination is a job. */
struct Batch
{
    std::string fileName;
    std::string output;  ///< absolute
    std::vector<Sequence> sequences;
    std::vector<std::string> strategies;
    std::vector<Variant> variants;
    std::vector<unsigned> seeds;
};

/** \param strategies  those that exist
 *  \throw std::exception naming file, section and key of what is wrong */
[[nodiscard]] Batch readBatch(const std::string& fileName,
                              const std::vector<std::string>& strategies);
}  // namespace monoslam
