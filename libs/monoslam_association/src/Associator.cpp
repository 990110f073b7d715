// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/Associator.h"

#include <map>
#include <stdexcept>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
using Registry = std::map<std::string, AssociatorFactory>;

Registry builtIns()
{
    return {{"none", makeUnvalidated},
            {"appearance_nn", makeAppearanceNN},
            {"spatial_nn", makeSpatialNN},
            {"one_point_ransac", makeOnePointRansac},
            {"active_search", makeActiveSearch},
            {"mhda", makeMhda},
            {"active_matching", makeActiveMatching},
            {"clam", makeClam},
            {"subam", makeSubam},
            {"ccda", makeCcda},
            {"cost_assignment", makeCostAssignment},
            {"jcbb", makeJcbb},
            {"hohct", makeHohct}};
}

Registry& registry()
{
    static Registry known = builtIns();
    return known;
}
}  // namespace

BatchOptions BatchOptions::from(const mrpt::config::CConfigFileBase& file,
                                const std::string& fileName)
{
    ConfigSection section(file, "association", fileName);
    const Range probability{1e-6, 1.0};
    BatchOptions o;
    static_cast<void>(section.get("strategy", ""));
    o.gate_probability = section.get("gate_probability", o.gate_probability, {1e-6, 1.0 - 1e-9});
    o.first_stage = section.get("first_stage_landmarks", o.first_stage, {0.0, 1e6});
    o.max_iterations = section.get("max_iterations", o.max_iterations, {1.0, 20.0});
    o.first_stage_candidates =
        section.get("first_stage_candidates", o.first_stage_candidates, {1.0, 100.0});
    o.first_stage_distance_px =
        section.get("first_stage_distance_px", o.first_stage_distance_px, {0.0, 1e6});
    o.max_measured = section.get("max_measured", o.max_measured, {1.0, 1e6});
    o.final_gate_probability =
        section.get("final_gate_probability", o.final_gate_probability, probability);
    section.rejectUnknownKeys();
    return o;
}

void registerAssociator(const std::string& name, AssociatorFactory factory)
{
    registry()[name] = std::move(factory);
}

std::vector<std::string> associatorNames()
{
    std::vector<std::string> names;
    for (const auto& entry : registry()) names.push_back(entry.first);
    return names;
}

std::unique_ptr<Associator> makeAssociator(const std::string& name,
                                           const mrpt::config::CConfigFileBase& file,
                                           const std::string& fileName)
{
    const auto entry = registry().find(name);
    if (entry != registry().end()) return entry->second(file, fileName);
    std::string known;
    for (const std::string& other : associatorNames()) known += (known.empty() ? "" : ", ") + other;
    throw std::invalid_argument("[association] strategy = " + name + ": unknown; known are " +
                                known);
}
}  // namespace monoslam
