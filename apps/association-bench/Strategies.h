// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

#include <memory>
#include <string>
#include <vector>

#include "Arguments.h"
#include "monoslam_association/Associator.h"

namespace monoslam
{
struct NamedAssociator
{
    std::string name;
    std::unique_ptr<Associator> associator;
};

/** The strategies that the command line asks for, and their options. */
class Strategies
{
   public:
    /** \throw std::exception naming an unknown strategy, section or key, or a value out of range */
    explicit Strategies(const Arguments& arguments);

    /** For problems as they come: options of [association...], defaults where there are none. */
    [[nodiscard]] std::vector<NamedAssociator> make() const;

    /** For drawn problems. Where the options say nothing: all landmarks are searched in one stage,
     *  all candidates are seen by every strategy that can take several, one linearisation. */
    [[nodiscard]] std::vector<NamedAssociator> makeFor(int landmarks, int candidates) const;

    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

   private:
    [[nodiscard]] std::vector<NamedAssociator> make(
        const mrpt::config::CConfigFileMemory& ini) const;

    std::string fileName_;
    std::vector<std::string> names_;
    std::string ini_;  ///< text: an ini of MRPT's cannot be copied
};
}  // namespace monoslam
