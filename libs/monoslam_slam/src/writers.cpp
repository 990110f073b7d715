// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/writers.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include "monoslam_support/csvCells.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
double meanNis(const std::vector<Association>& associations)
{
    double sum = 0.0;
    int count = 0;
    for (const auto& a : associations)
        if (a.fate == Fate::Matched) sum += a.nis, ++count;
    return count == 0 ? 0.0 : sum / count;
}

constexpr const char* kFrameColumns =
    "index,t_s,state,remark,prepare_ms,predict_ms,search_ms,associate_ms,update_ms,map_ms,"
    "total_ms,decode_ms,landmarks,visible,candidates,pairs,rejected,nodes,leaves,d2_evaluations,"
    "joint_d2,mean_nis,residual_rms_px,matched,added,removed,beliefs,effective_beliefs,"
    "belief_distance,belief_angle_rad,ancestor_age_frames,proved,capped\n";

std::string frameLine(const FrameReport& r, double decode_ms)
{
    std::string line = std::to_string(r.index) + "," + number(r.t_s, "%.7f") + "," + name(r.state) +
                       "," + quoted(r.remark);
    const StageTimes& t = r.times;
    for (const double ms : {t.prepare_ms, t.predict_ms, t.search_ms, t.associate_ms, t.update_ms,
                            t.map_ms, t.total_ms, decode_ms})
        line += "," + number(ms, "%.4f");
    const AssociationCounters& c = r.counters;
    for (const long count :
         {static_cast<long>(r.landmarks), static_cast<long>(r.visible),
          static_cast<long>(r.candidates), c.pairs, c.rejected, c.nodes, c.leaves, c.d2Evaluations})
        line += "," + std::to_string(count);
    for (const double value : {c.jointD2, meanNis(r.associations), r.residualRms_px})
        line += "," + number(value, "%.6g");
    for (const int count : {r.matched, r.added, r.removed}) line += "," + std::to_string(count);
    const Diversity& d = r.diversity;
    line += "," + std::to_string(d.beliefs);
    for (const double value : {d.effective, d.distance, d.angle_rad})
        line += "," + number(value, "%.6g");
    line += "," + std::to_string(d.ancestorAge_frames);
    return line + (c.provedOptimal ? ",1," : ",0,") + std::to_string(c.capped) + "\n";
}

std::string covarianceHeader()
{
    std::string header = "t_s";
    const char* axes[] = {"rx", "ry", "rz", "thx", "thy", "thz"};
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) header += std::string(",") + axes[i] + "_" + axes[j];
    return header + "\n";
}

std::string covarianceLine(const FrameReport& report)
{
    const auto P = poseCovariance(report.x_v, report.P_v);
    std::string line = number(report.t_s, "%.7f");
    for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) line += "," + number(P(i, j));
    return line + "\n";
}

bool isOurs(const std::string& fileName)
{
    static const std::regex ours(
        "trajectory\\.tum|robot_path\\.tum|groundtruth\\.tum|covariance\\.csv|frames\\.csv|"
        "associations\\.csv|errors\\.csv|map\\.csv|map\\.ply|map\\.3Dscene|summary\\.json|"
        "top_view\\.png|frame_[0-9]+\\.(png|jpg)|association_[0-9]+\\.json");
    return std::regex_match(fileName, ours);
}

void removeOurs(const fs::path& folder)
{
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.symlink_status().type() == fs::file_type::regular &&
            isOurs(entry.path().filename().string()))
            fs::remove(entry.path());
}
}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), stream_(path)
{
    if (!stream_) throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

void OutputFile::write(const std::string& lines)
{
    errno = 0;
    stream_ << lines << std::flush;
    if (stream_)
    {
        size_ += lines.size();
        return;
    }
    const std::string reason = errno == 0 ? "write failed" : std::strerror(errno);
    stream_.close();
    std::error_code ignored;  // a device has no size
    if (fs::is_regular_file(path_, ignored)) fs::resize_file(path_, size_, ignored);
    throw std::runtime_error(path_ + ": cannot be written: " + reason);
}

void checkOutputFolder(const std::string& folder, bool force)
{
    std::error_code failed;
    if (!fs::exists(folder)) return;
    if (!fs::is_directory(folder)) throw std::runtime_error(folder + ": is not a folder");
    const bool empty = fs::is_empty(folder, failed);
    if (failed) throw std::runtime_error(folder + ": cannot be read: " + failed.message());
    if (!empty && !force)
        throw std::runtime_error(folder +
                                 ": the output folder is not empty; use --force to "
                                 "replace the files of an earlier run");
}

void writeTextFile(const std::string& path, const std::string& text, bool force)
{
    if (path != "/dev/stdout" && fs::exists(path) && !force)
        throw std::runtime_error(path + ": exists; use --force to replace it");
    OutputFile(path).write(text);
}

void prepareOutputFolder(const std::string& folder, bool force)
{
    checkOutputFolder(folder, force);
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) throw std::runtime_error(folder + ": cannot be created: " + failed.message());
    removeOurs(folder);
    removeOurs(fs::path(folder) / "pictures");
}

std::string tumLine(double t_s, const Vector7d& pose)
{
    std::string line = number(t_s, "%.7f");
    for (const int i : {0, 1, 2, 4, 5, 6, 3}) line += " " + number(pose[i]);
    return line + "\n";
}

FrameWriters::FrameWriters(const std::string& folder)
    : trajectory_(folder + "/trajectory.tum"),
      covariance_(folder + "/covariance.csv"),
      frames_(folder + "/frames.csv")
{
    covariance_.write(covarianceHeader());
    frames_.write(kFrameColumns);
}

void FrameWriters::write(const FrameReport& report, double decode_ms)
{
    frames_.write(frameLine(report, decode_ms));
    if (!report.hasPose()) return;
    Vector7d pose = report.x_v.head<camera_state::kPoseSize>();
    pose.tail<4>().normalize();
    trajectory_.write(tumLine(report.t_s, pose));
    covariance_.write(covarianceLine(report));
}
}  // namespace monoslam
