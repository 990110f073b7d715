// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "builtPlaces.h"

namespace monoslam
{
/** Folder of the real sequences, which are not ours to ship: MONOSLAM_DATASETS, else
 * ../shared/datasets beside the source tree; nothing where that does not exist.
 *
 *      const auto datasets = realDatasets();
 *      if (!datasets) GTEST_SKIP() << noRealDatasets; */
inline std::optional<std::filesystem::path> realDatasets()
{
    const char* named = std::getenv("MONOSLAM_DATASETS");
    const std::filesystem::path folder =
        named ? std::filesystem::path(named)
              : std::filesystem::path(MONOSLAM_SOURCE_DIR) / ".." / "shared" / "datasets";
    if (!std::filesystem::is_directory(folder)) return std::nullopt;
    return std::filesystem::canonical(folder);
}

inline constexpr const char* noRealDatasets =
    "no real sequences: neither ../shared/datasets nor MONOSLAM_DATASETS is a folder";

/** What is shipped with the source: configurations, the rendered sequence. */
inline std::filesystem::path sourceFolder()
{
    return MONOSLAM_SOURCE_DIR;
}

/** Where the programs are built. */
inline std::filesystem::path programFolder()
{
    return MONOSLAM_BIN_DIR;
}
}  // namespace monoslam
