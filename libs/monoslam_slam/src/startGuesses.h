// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monoslam_filter/smoothWindow.h"

namespace monoslam
{
/** Other places from which to estimate a window, for when the filter's own guess fits badly: small
 *  parallax has mirrored solutions (near and far exchanged), and the filter may sit in one. */

/** All landmarks at the median depth and no motion at all. */
[[nodiscard]] Window flatGuess(Window window);

/** Essential matrix between the first and the last view, other views in between, depths by
 *  intersection, scaled to the window's median depth.
 *  \return nothing if too few pixels are common or no motion is found */
[[nodiscard]] std::optional<Window> twoViewGuess(Window window, const Camera& camera);
}  // namespace monoslam
