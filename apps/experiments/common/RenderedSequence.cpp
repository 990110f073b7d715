// SPDX-License-Identifier: BSD-3-Clause
#include "RenderedSequence.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>

#include "monoslam_eval/Trajectory.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_mrpt/makeEngine.h"

namespace monoslam
{
namespace
{
constexpr double kSameTime_s = 1e-5;

std::string contents(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void readImageList(RenderedSequence& sequence)
{
    std::istringstream lines(contents(sequence.folder + "/rgb.txt"));
    for (std::string line; std::getline(lines, line);)
    {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream fields(line);
        double t_s = 0.0;
        std::string file;
        if (!(fields >> t_s >> file))
            throw std::runtime_error(sequence.folder + "/rgb.txt: bad line: " + line);
        sequence.times_s.push_back(t_s);
        sequence.images.push_back(sequence.folder + "/" + file);
    }
}

void override(mrpt::config::CConfigFileMemory& file, const std::string& text)
{
    const auto equals = text.find('=');
    const auto dot = text.rfind('.', equals);
    if (equals == std::string::npos || dot == std::string::npos)
        throw std::invalid_argument("'" + text + "' is not section.key=value");
    file.write(text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
               text.substr(equals + 1));
}
}  // namespace

RenderedSequence readRenderedSequence(const std::string& folder)
{
    RenderedSequence sequence;
    sequence.folder = folder;
    sequence.camera = readCameraFile(folder + "/camera.yaml").camera;
    readImageList(sequence);
    const Trajectory truth = readTum(folder + "/groundtruth.txt");
    std::size_t at = 0;
    for (const double t_s : sequence.times_s)
    {
        while (at < truth.size() && truth[at].t_s < t_s - kSameTime_s) ++at;
        if (at == truth.size() || std::abs(truth[at].t_s - t_s) > kSameTime_s)
            throw std::runtime_error(folder + "/groundtruth.txt: no pose at " +
                                     std::to_string(t_s));
        Vector7d pose;
        pose << truth[at].r_wc, truth[at].q_wc.normalized();
        sequence.poses.push_back(pose);
    }
    return sequence;
}

void runSequence(const RenderedSequence& sequence, const RunSettings& settings,
                 const FrameVisitor& visit)
{
    mrpt::config::CConfigFileMemory file;
    file.setContent(contents(settings.configFile));
    for (const std::string& text : settings.overrides) override(file, text);
    const MonoSlamOptions options = MonoSlamOptions::from(file, settings.configFile);
    MonoSlam slam(options, Camera(sequence.camera),
                  makeAssociator(settings.strategy, file, settings.configFile), settings.seed,
                  makeEngine(options.engine));
    for (std::size_t i = 0; i < sequence.images.size(); ++i)
    {
        Frame frame;
        frame.t_s = sequence.times_s[i];
        frame.index = static_cast<long>(i);
        frame.image = cv::imread(sequence.images[i], cv::IMREAD_GRAYSCALE);
        if (frame.image.empty())
            throw std::runtime_error(sequence.images[i] + ": cannot be decoded");
        const FrameReport report = slam.process(frame);
        visit(frame, report, slam);
    }
}
}  // namespace monoslam
