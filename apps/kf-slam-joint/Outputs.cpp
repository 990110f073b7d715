// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/poses/CPose3DQuat.h>

#include <cstdio>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include "compareWithTruth.h"
#include "drawState.h"

namespace monoslam
{
namespace fs = std::filesystem;
using mrpt::obs::CObservationBearingRange;

namespace
{
void prepareFolder(const std::string& folder, bool force)
{
    checkOutputFolder(folder, force);
    fs::create_directories(folder);
    const std::regex ours(
        "(robot_pose|full_cov|slam_state|kf_state)_[0-9]{5,}\\.(txt|m|3Dscene)|"
        "data_association(_performance)?\\.log|estimated_path\\.tum");
    for (const auto& entry : fs::directory_iterator(folder))
        if (std::regex_match(entry.path().filename().string(), ours)) fs::remove(entry.path());
}

Vector7d toVector(const mrpt::poses::CPose3D& pose)
{
    const mrpt::poses::CPose3DQuat p(pose);
    Vector7d v;
    v << p.x(), p.y(), p.z(), p.quat().r(), p.quat().x(), p.quat().y(), p.quat().z();
    return v;
}

void mustBeWritten(const std::string& file)
{
    std::error_code failed;
    if (fs::file_size(file, failed) == 0 || failed)
        throw std::runtime_error(file + ": cannot be written (disk full?)");
}
}  // namespace

Outputs::Outputs(const Config& config, bool force) : config_(config), folder_(config.output)
{
    truth_ = readTruePath(config.truthOfPath);
    prepareFolder(folder_, force);
    trajectory_ = std::make_unique<OutputFile>(folder_ + "/estimated_path.tum");
    log_ = std::make_unique<AssociationLog>(folder_, config.saveAssociations,
                                            config.truthOfAssociation);
}

std::string Outputs::file(const char* format) const
{
    char name[60];
    std::snprintf(name, sizeof name, format, static_cast<unsigned>(path_.size() - 1));
    return folder_ + name;
}

void Outputs::add(const Step& step, const Filter& filter)
{
    path_.push_back(filter.pose());
    frames_.push_back(step.frame);
    const auto observation = step.observations->getObservationByClass<CObservationBearingRange>();
    if (observation)
    {
        for (const auto& seen : observation->sensedData)
            haveIds_ = haveIds_ || seen.landmarkID >= 0;
        log_->write(*observation, filter);
        trajectory_->write(
            tumLine(mrpt::Clock::toDouble(observation->timestamp), toVector(path_.back())));
    }
    if ((static_cast<long>(path_.size()) - 1) % config_.saveEvery == 0) saveState(filter);
}

void Outputs::saveState(const Filter& filter) const
{
    const std::string pose = file("/robot_pose_%05u.txt"), P = file("/full_cov_%05u.txt");
    filter.poseVector().saveToTextFile(pose);
    filter.covariance().saveToTextFile(P);
    mustBeWritten(pose);
    mustBeWritten(P);
    if (config_.saveMaps)
    {
        filter.saveAsMatlab(file("/slam_state_%05u.m"));
        mustBeWritten(file("/slam_state_%05u.m"));
    }
    if (config_.saveScenes) saveScene(filter);
}

void Outputs::saveScene(const Filter& filter) const
{
    const std::string name = file("/kf_state_%05u.3Dscene");
    if (!drawState(filter, path_, truth_)->saveToFile(name))
        throw std::runtime_error(name + ": cannot be written");
}
}  // namespace monoslam
