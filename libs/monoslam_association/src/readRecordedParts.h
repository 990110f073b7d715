// SPDX-License-Identifier: BSD-3-Clause
// Parts of the format of recordedFrameFile.h; all throw std::invalid_argument as that says.
#pragma once

#include <string>

#include "JsonValue.h"
#include "monoslam_filter/Belief.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
template <typename Names>
[[nodiscard]] auto namedValue(const Names& names, const JsonValue& value)
{
    const std::string text = value.text();
    std::string known;
    for (const auto& entry : names)
    {
        if (text == entry.first) return entry.second;
        known += (known.empty() ? "" : ", ") + std::string(entry.first);
    }
    value.fail("unknown " + text + "; known are " + known);
}

[[nodiscard]] int smallNumber(const JsonValue& value);
[[nodiscard]] Camera readCamera(const JsonValue& value);
/** Its invariant holds. */
[[nodiscard]] WeightedBelief readBelief(const JsonValue& value);
}  // namespace monoslam
