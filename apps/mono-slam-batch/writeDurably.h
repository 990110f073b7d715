// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace monoslam
{
/** Replaces a file as a whole: whoever reads it, even after a power cut, finds the old content or
 *  the new. \throw std::runtime_error naming the file; then the old one is still there */
void writeDurably(const std::string& path, const std::string& text);

/** Waits until all files of a folder, not of those within it, are on the disk.
 *  \throw std::runtime_error naming the file */
void syncFolder(const std::string& folder);
}  // namespace monoslam
