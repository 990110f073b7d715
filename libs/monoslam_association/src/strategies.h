// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace mrpt::config
{
class CConfigFileBase;
}

namespace monoslam
{
class Associator;
using IniFile = mrpt::config::CConfigFileBase;

std::unique_ptr<Associator> makeUnvalidated(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeAppearanceNN(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeSpatialNN(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeOnePointRansac(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeActiveSearch(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeMhda(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeActiveMatching(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeClam(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeSubam(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeCcda(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeCostAssignment(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeJcbb(const IniFile& file, const std::string& fileName);
std::unique_ptr<Associator> makeHohct(const IniFile& file, const std::string& fileName);
}  // namespace monoslam
