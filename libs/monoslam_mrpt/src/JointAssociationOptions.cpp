// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFileBase.h>

#include <stdexcept>

#include "monoslam_mrpt/RangeBearingKFSLAM.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
constexpr const char* kSection = "RangeBearingKFSLAM";
constexpr const char* kKey = "data_assoc_method";

[[noreturn]] void failMethod(const std::string& value)
{
    std::string known;
    for (const auto& [name, method] :
         mrpt::typemeta::TEnumType<DataAssociationMethod>::getBimap().m_v2k)
        known += (known.empty() ? "" : ", ") + name;
    throw std::invalid_argument(std::string("[") + kSection + "] " + kKey + " = " + value +
                                ": unknown; known are " + known);
}

DataAssociationMethod readMethod(const mrpt::config::CConfigFileBase& ini)
{
    DataAssociationMethod method = assocNN;
    const std::string value = ini.read_string_first_word(kSection, kKey, "");
    try
    {
        method = ini.read_enum<DataAssociationMethod>(kSection, kKey, method, true);
    }
    catch (const std::exception&)
    {
        failMethod(value);
    }
    if (method < assocNN || method > assocJCBB_MRPT) failMethod(value);
    return method;
}
}  // namespace

JointAssociationOptions JointAssociationOptions::from(const mrpt::config::CConfigFileBase& ini)
{
    JointAssociationOptions o;
    if (ini.keyExists(kSection, kKey)) o.method = readMethod(ini);
    ConfigSection section(ini, "RangeBearingKFSLAM_Joint");
    o.joint_chi2_thres = section.get("joint_chi2_thres", o.joint_chi2_thres, {0.0, 1.0 - 1e-12});
    o.node_cap = section.get("node_cap", o.node_cap, {1.0, 1e9});
    o.insert_rejected = section.get("insert_rejected", o.insert_rejected);
    if (section.has("remove_missed")) o.remove_missed = section.get("remove_missed", true);
    o.p_detection = section.get("p_detection", o.p_detection, {0.5, 1.0 - 1e-6});
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
