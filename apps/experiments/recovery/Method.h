// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "monoslam_association/Associator.h"

namespace monoslam
{
/** A strategy with the options in which it differs from its defaults. */
struct Method
{
    std::string name;           ///< as the table calls it
    std::string strategy;       ///< of associatorNames()
    std::string options = {};   ///< lines of its ini section
    bool heaviestOnly = false;  ///< of the beliefs after a frame, one alone goes on

    [[nodiscard]] std::shared_ptr<const Associator> make() const;
};

/** Every registered strategy with its defaults, but MHDA draws once a frame, as the second paper
 *  has it. */
[[nodiscard]] std::vector<Method> allStrategies();

/** MHDA with every number of particles under study and every resampling scheme; at last without
 *  what it is named for: the heaviest particle alone goes on to the next frame. */
[[nodiscard]] std::vector<Method> mhdaVariants();
}  // namespace monoslam
