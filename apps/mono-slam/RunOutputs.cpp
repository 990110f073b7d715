// SPDX-License-Identifier: BSD-3-Clause
#include "RunOutputs.h"

#include <mrpt/poses/CPose3DQuat.h>
#include <mrpt/system/os.h>

#include <cstdio>
#include <filesystem>
#include <opencv2/core/version.hpp>

#include "drawPictures.h"
#include "monoslam_mrpt/scene3d.h"

namespace monoslam
{
using mrpt::poses::CPose3D;

namespace
{
Vector7d toVector(const CPose3D& pose)
{
    const mrpt::poses::CPose3DQuat p(pose);
    Vector7d v;
    v << p.x(), p.y(), p.z(), p.quat().r(), p.quat().x(), p.quat().y(), p.quat().z();
    return v;
}

CPose3D toPose(const Vector7d& v)
{
    return CPose3D(mrpt::math::CQuaternionDouble(v[3], v[4], v[5], v[6]), v[0], v[1], v[2]);
}

std::map<std::string, std::string> versions()
{
    return {
        {"monoslam", MONOSLAM_VERSION},
        {"mrpt", mrpt::system::MRPT_getVersion()},
        {"opencv", CV_VERSION},
        {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                      "." + std::to_string(EIGEN_MINOR_VERSION)},
        {"compiler", __VERSION__}};
}
}  // namespace

RunOutputs::RunOutputs(const Config& config, const Arguments& arguments, const RawlogReader& reader)
    : folder_(config.output.directory), options_(config.output), cameraPose_(reader.cameraPose())
{
    prepareOutputFolder(folder_, arguments.force);
    facts_.seed = arguments.seed;
    facts_.input = {{"rawlog", config.rawlog.file},
                    {"config", config.fileName},
                    {"sensor_label", reader.sensorLabel()},
                    {"frames", std::to_string(reader.frameCount())}};
    facts_.versions = versions();
    facts_.config = config.values;
    facts_.notes = reader.gaps();
    if (!reader.damage().empty()) facts_.notes.push_back(reader.damage());
    frames_ = std::make_unique<FrameWriters>(folder_);
    if (options_.associations) associations_ = std::make_unique<AssociationCsv>(folder_);
    if (!arguments.robotPath.empty())
        robotPath_ = std::make_unique<OutputFile>(arguments.robotPath);
    if (!reader.groundTruth().empty()) writeTruth(reader.groundTruth());
    if (options_.pictures) std::filesystem::create_directories(folder_ + "/pictures");
}

void RunOutputs::writeTruth(const std::vector<RecordedPose>& poses) const
{
    std::string lines;
    for (const auto& pose : poses) lines += tumLine(seconds(pose.t), toVector(pose.pose));
    OutputFile(folder_ + "/groundtruth.tum").write(lines);
}

void RunOutputs::add(const Frame& frame, const FrameReport& report, const MonoSlam& slam,
                     double decode_ms)
{
    frames_->write(report, decode_ms);
    if (associations_) associations_->write(report);
    summary_.add(report, decode_ms);
    lastRemark_ = report.remark;
    if (report.hasPose())
    {
        Vector7d pose = report.x_v.head<camera_state::kPoseSize>();
        pose.tail<4>().normalize();
        path_.push_back(pose);
        if (robotPath_)
            robotPath_->write(tumLine(report.t_s, toVector(toPose(pose) - cameraPose_)));
    }
    if (options_.pictures && frame.index % options_.picture_every_nth == 0)
        addPicture(frame, report, slam);
}

void RunOutputs::addPicture(const Frame& frame, const FrameReport& report, const MonoSlam& slam)
{
    std::vector<MapLandmark> added;
    std::set<LandmarkId> present;
    for (auto& landmark : slam.map())
    {
        present.insert(landmark.id);
        if (!drawn_.count(landmark.id)) added.push_back(std::move(landmark));
    }
    drawn_ = std::move(present);
    char name[40];
    std::snprintf(name, sizeof name, "/pictures/frame_%06ld.jpg", frame.index);
    savePicture(folder_ + name, drawFrame(frame.image, report, added, slam.camera()));
}

void RunOutputs::finish(const MonoSlam& slam, bool interrupted)
{
    const auto map = slam.map();
    facts_.interrupted = interrupted;
    summary_.setMap(map);
    writeMapCsv(folder_, map);
    writeMapPly(folder_, map);
    writeScene3d(folder_ + "/map.3Dscene", path_, map);
    if (options_.pictures) savePicture(folder_ + "/top_view.png", drawTopView(path_, map));
    summary_.write(folder_, facts_);
}
}  // namespace monoslam
