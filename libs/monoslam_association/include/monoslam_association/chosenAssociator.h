// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <set>
#include <string>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** What [association] strategy names, hohct if it says nothing. The sections of the others are
 *  checked as well, by making them. \throw std::invalid_argument as makeAssociator() does */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::unique_ptr<Associator> chosenAssociator(
    const mrpt::config::CConfigFileBase& file, const std::string& fileName);

/** association, and association.NAME of every strategy. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::set<std::string> associationSections();
}  // namespace monoslam
