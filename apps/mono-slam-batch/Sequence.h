// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
/** One rawlog of a batch, with all that its runs have in common; files are absolute paths. */
struct Sequence
{
    std::string name;
    std::string section;  ///< where it comes from, for messages
    std::string rawlog;
    std::string config;
    std::string truth;      ///< empty: none
    std::string depth;      ///< folder of depth pictures for landmark errors; empty: none
    std::string camera;     ///< of these; empty: as mono-slam-eval finds it
    std::string alignment;  ///< of the errors per frame
    bool outAndBack = false;
    std::vector<std::string> settings;  ///< "section.key=value"
    std::string fingerprint;            ///< differs as soon as the content of a file does
};

/** The sequences of a section [sequence.NAME]: one a rawlog that its pattern finds. That of a plain
 *  file is called NAME; others NAME.REST, where REST is the path from the first wildcard on, with
 *  "_" for "/" and without extension.
 *  \param folder  what relative paths are relative to
 *  \throw std::invalid_argument naming file, section and key */
[[nodiscard]] std::vector<Sequence> readSequences(ConfigSection section, const std::string& folder);
}  // namespace monoslam
