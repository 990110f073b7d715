// SPDX-License-Identifier: BSD-3-Clause
#include "Config.h"

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/readIni.h"

namespace monoslam
{
namespace fs = std::filesystem;
using mrpt::config::CConfigFileMemory;

namespace
{
constexpr const char* kApplication = "MappingApplication";

/** Keys of MRPT's sections that are numbers, which it reads as 0 when they are none. */
const std::map<std::string, std::vector<const char*>> kNumbers = {
    {"RangeBearingKFSLAM",
     {"std_sensor_range", "std_sensor_yaw_deg", "std_sensor_pitch_deg", "std_odo_z_additional",
      "quantiles_3D_representation", "data_assoc_IC_chi2_thres", "data_assoc_IC_ml_threshold"}},
    {"RangeBearingKFSLAM_KalmanFilter", {"IKF_iterations"}}};

const std::map<std::string, std::set<std::string>> kOtherKeys = {
    {"RangeBearingKFSLAM",
     {"stds_Q_no_odo", "doPartitioningExperiment", "partitioningMethod", "create_simplemap",
      "force_ignore_odometry", "data_assoc_method", "data_assoc_metric", "data_assoc_IC_metric",
      "partitionThreshold", "gridResolution", "minDistForCorrespondence", "useMapMatching",
      "minimumNumberElementsEachCluster"}},
    {"RangeBearingKFSLAM_KalmanFilter",
     {"method", "verbosity_level", "enable_profiler", "use_analytic_transition_jacobian",
      "use_analytic_observation_jacobian", "debug_verify_analytic_jacobians",
      "debug_verify_analytic_jacobians_threshold"}}};

void readApplication(Config& config, const std::string& fileName)
{
    ConfigSection section(config.ini, kApplication, fileName);
    const auto input = [&](const char* key)
    {
        const std::string name = section.get(key, "");
        if (name.empty()) return name;
        const fs::path path = fs::path(fileName).parent_path() / name;
        return path.lexically_normal().string();
    };
    config.rawlog = input("rawlog_file");
    config.truthOfLandmarks = input("ground_truth_file");
    config.truthOfPath = input("ground_truth_file_robot");
    config.truthOfAssociation = input("ground_truth_data_association");
    config.output = section.get("logOutput_dir", config.output);
    config.firstEntry = section.get("rawlog_offset", 0, {0.0, 1e9});
    config.saveEvery = section.get("SAVE_LOG_FREQUENCY", 1, {1.0, 1e9});
    config.saveAssociations = section.get("SAVE_DA_LOG", config.saveAssociations);
    config.saveScenes = section.get("SAVE_3D_SCENES", config.saveScenes);
    config.saveMaps = section.get("SAVE_MAP_REPRESENTATIONS", config.saveMaps);
    config.inPlane =
        section.get<bool>("kf_implementation", false,
                          {{"CRangeBearingKFSLAM", false}, {"CRangeBearingKFSLAM2D", true}});
    if (section.get("SHOW_3D_LIVE", false))
        config.warnings.emplace_back("SHOW_3D_LIVE: there is no live view; see SAVE_3D_SCENES");
    static_cast<void>(section.get("CAMERA_3DSCENE_FOLLOWS_ROBOT", false));
    try
    {
        section.rejectUnknownKeys();
    }
    catch (const std::invalid_argument& e)
    {
        config.warnings.emplace_back(std::string(e.what()) + " (ignored, as kf-slam does)");
    }
}

void checkMrptSections(Config& config, const std::string& fileName)
{
    for (const auto& [name, numbers] : kNumbers)
    {
        ConfigSection section(config.ini, name, fileName);
        std::set<std::string> known = kOtherKeys.at(name);
        for (const char* key : numbers)
        {
            static_cast<void>(section.get(key, 0.0));
            known.insert(key);
        }
        std::vector<std::string> present;
        config.ini.getAllKeys(name, present);
        std::string where = fileName;
        where.append(": [").append(name).append("] ");
        for (const auto& key : present)
            if (known.count(key) == 0)
                config.warnings.emplace_back(where).append(key).append(
                    ": unknown (ignored, as kf-slam does)");
    }
}

void checkInputs(const Config& config)
{
    if (config.rawlog.empty())
        throw std::invalid_argument("[MappingApplication] rawlog_file: no rawlog is given");
    for (const std::string& file :
         {config.truthOfLandmarks, config.truthOfPath, config.truthOfAssociation})
        if (!file.empty() && !fs::is_regular_file(file))
            throw std::runtime_error(file + ": no such file of ground truth");
}
}  // namespace

Config loadConfig(const Arguments& arguments)
{
    Config config;
    readIni(arguments.configFile, arguments.settings, config.ini);
    rejectUnknownSections(config.ini,
                          {kApplication, "RangeBearingKFSLAM", "RangeBearingKFSLAM_KalmanFilter",
                           "RangeBearingKFSLAM_Joint", "RangeBearingKFSLAM_MHDA"},
                          arguments.configFile);
    readApplication(config, arguments.configFile);
    checkMrptSections(config, arguments.configFile);
    if (!arguments.rawlog.empty()) config.rawlog = arguments.rawlog;
    if (!arguments.output.empty()) config.output = arguments.output;
    config.seed = arguments.seed;
    checkInputs(config);
    return config;
}
}  // namespace monoslam
