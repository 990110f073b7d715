// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monoslam_association/RecordedFrame.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** An association problem as text: JSON with one landmark and one row of a matrix a line, numbers
 *  with all their bits. The layout stands in docs/association-bench.md.
 *  \throw std::invalid_argument if a number is not finite: the format has none */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::string toText(const RecordedFrame& frame);

/** \param fileName  only named in errors
 *  \throw std::invalid_argument naming file and key of what is missing, unknown, ill-typed or of the
 *  wrong size, and if h, H or S is not what belief and camera predict */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT RecordedFrame
recordedFrameFromText(const std::string& text, const std::string& fileName);

/** \throw std::runtime_error if the file cannot be read, else as above */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT RecordedFrame
readRecordedFrame(const std::string& fileName);
}  // namespace monoslam
