// SPDX-License-Identifier: BSD-3-Clause
// kf-slam-joint beside kf-slam, on the samples of the packages mrpt-common and mrpt-apps.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "TemporaryFolder.h"
#include "copyWithClutter.h"
#include "kfSlamRuns.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;

const fs::path kMrpt = "/usr/share/mrpt";
const fs::path kIni = kMrpt / "config_files/kf-slam/EKF-SLAM_6D_test_datassoc.ini";
const fs::path kRawlog = kMrpt / "datasets/kf-slam_6D_demo_DA.rawlog";
constexpr const char* kMissing = "the packages mrpt-common and mrpt-apps are not installed";

bool samplesAreThere()
{
    return fs::exists(kIni) && fs::exists(kRawlog) && runShell("command -v kf-slam").status == 0;
}

double rmse(const ProgramResult& result)
{
    std::smatch found;
    const std::regex line("path: RMSE ([0-9.]+) m");
    if (result.status != 0 || !std::regex_search(result.output, found, line))
        throw std::runtime_error(result.output);
    return std::stod(found[1]);
}

std::vector<double> numbersOf(const fs::path& file)
{
    std::string text = readText(file.string());
    for (char& c : text)
        if (std::string("[];,(){}").find(c) != std::string::npos) c = ' ';
    std::istringstream words(text);
    std::vector<double> numbers;
    for (std::string word; words >> word;)
    {
        char* end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        if (*end == '\0') numbers.push_back(number);
    }
    return numbers;
}

std::set<std::string> filesIn(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

/** Both programs on the same options; the folders that they wrote. */
struct Both
{
    fs::path theirs, ours;
};

Both runBoth(const std::string& ini, const fs::path& rawlog, const TemporaryFolder& folder)
{
    const std::string theirs = (folder / "theirs.ini"), ours = (folder / "ours.ini");
    writeText(theirs, ini + "[MappingApplication]\nlogOutput_dir = " + (folder / "theirs") + "\n");
    writeText(ours, ini);
    const auto kfSlam = runShell("kf-slam '" + theirs + "' '" + rawlog.string() + "'");
    EXPECT_EQ(kfSlam.status, 0) << kfSlam.output;
    const auto result = kfSlamJoint("'" + ours + "' '" + rawlog.string() + "' --output '" +
                                    (folder / "ours") + "'");
    EXPECT_EQ(result.status, 0) << result.output;
    return {(folder / "theirs"), (folder / "ours")};
}

/** The same files, with the same numbers in those of text that bear the state. */
void expectSameFiles(const Both& both)
{
    auto ours = filesIn(both.ours);
    EXPECT_EQ(ours.erase("estimated_path.tum"), 1U);
    EXPECT_EQ(ours, filesIn(both.theirs));
    for (const std::string& name : ours)
    {
        const bool state =
            std::regex_search(name, std::regex("^(robot_pose|full_cov|slam_state)_"));
        if (!state) continue;
        const auto a = numbersOf(both.ours / name), b = numbersOf(both.theirs / name);
        ASSERT_EQ(a.size(), b.size()) << name;
        ASSERT_GT(a.size(), 2U) << name;
        for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-6) << name;
    }
}
}  // namespace

TEST(KfSlamJoint, WritesWhatKfSlamWrites)
{
    if (!samplesAreThere()) GTEST_SKIP() << kMissing;
    const TemporaryFolder folder;
    std::string ini = readText(kIni.string());
    ini = std::regex_replace(
        ini, std::regex("(\n)(rawlog_file|ground_truth|SHOW|SAVE|logOutput)[^\n]*"), "$1");
    ini = std::regex_replace(ini, std::regex("assocJCBB"), "ASSOCIATION");
    const std::string options =
        "[MappingApplication]\nSAVE_LOG_FREQUENCY = 40\nSHOW_3D_LIVE = false\n"
        "SAVE_3D_SCENES = true\nSAVE_MAP_REPRESENTATIONS = true\n";
    const std::string theirs = std::regex_replace(ini, std::regex("ASSOCIATION"), "assocJCBB");
    const Both both = runBoth(theirs + options, kRawlog, folder);
    expectSameFiles(both);
    EXPECT_GT(fs::file_size(both.ours / "kf_state_00200.3Dscene"), 1000U);
    // kf-slam leaves out which landmarks it added; all else of its log is ours as well.
    std::ifstream a((both.ours / "data_association.log").string());
    std::ifstream b((both.theirs / "data_association.log").string());
    long compared = 0;
    for (std::string ours, kfSlams; std::getline(a, ours) && std::getline(b, kfSlams); ++compared)
    {
        if (kfSlams.find("         -1 ") != std::string::npos) continue;
        ASSERT_EQ(ours, kfSlams);
    }
    EXPECT_GT(compared, 1000);
}

TEST(KfSlamJoint, WritesWhatKfSlamWritesInThePlane)
{
    const fs::path rawlog = kMrpt / "datasets/kf-slam_demo.rawlog";
    if (!samplesAreThere() || !fs::exists(rawlog)) GTEST_SKIP() << kMissing;
    const TemporaryFolder folder;
    const Both both = runBoth(
        "[MappingApplication]\nkf_implementation = CRangeBearingKFSLAM2D\n"
        "SAVE_LOG_FREQUENCY = 50\nSAVE_3D_SCENES = false\n[RangeBearingKFSLAM]\n"
        "std_sensor_range = 0.03\nstd_sensor_yaw_deg = 0.1\n",
        rawlog, folder);
    expectSameFiles(both);
}

TEST(KfSlamJoint, IsNeverWorseThanKfSlamOnItsSample)
{
    if (!samplesAreThere()) GTEST_SKIP() << kMissing;
    const TemporaryFolder folder;
    const auto run = [&](const std::string& name)
    {
        return kfSlamJoint("'" + kIni.string() + "' --force --output '" + (folder / "out") + "'" +
                           setting("MappingApplication.SAVE_LOG_FREQUENCY=1000") + method(name));
    };
    const double theirs = rmse(run("JCBB_MRPT"));
    for (const char* name : {"NN", "JCBB", "HOHCT", "MHDA", "assocJCBB", "NN_MRPT"})
        EXPECT_LE(rmse(run(name)), theirs + 1e-6) << name;
    EXPECT_LT(theirs, 0.203);
}

TEST(KfSlamJoint, IsBetterThanKfSlamUnderClutter)
{
    if (!samplesAreThere()) GTEST_SKIP() << kMissing;
    const TemporaryFolder folder;
    const auto run = [&](const std::string& name, unsigned seed)
    {
        const std::string rawlog = (folder / "echo.rawlog");
        copyWithClutter(kRawlog.string(), rawlog, Clutter::Echo, 1.0, seed);
        return rmse(kfSlamJoint(
            "'" + kIni.string() + "' '" + rawlog + "' --force --output '" + (folder / "out") + "'" +
            setting("MappingApplication.SAVE_LOG_FREQUENCY=1000") + method(name)));
    };
    double mrpts = 0.0;
    std::map<std::string, double> ours{{"NN", 0.0}, {"JCBB", 0.0}, {"HOHCT", 0.0}, {"MHDA", 0.0}};
    for (const unsigned seed : {1U, 2U, 3U, 4U})
    {
        mrpts += std::pow(run("JCBB_MRPT", seed), 2);
        for (auto& [name, squares] : ours) squares += std::pow(run(name, seed), 2);
    }
    for (const auto& [name, squares] : ours) EXPECT_LT(squares, mrpts) << name;
}
}  // namespace monoslam
