// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RawlogReader.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "monoslam_mrpt/ObservationStream.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
std::string sizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

/** The label to read, which must be named if there are several. */
std::string chooseLabel(const RawlogOptions& options, const RawlogContents& contents)
{
    std::string known;
    for (const auto& [label, times] : contents.imageTimes)
        known += (known.empty() ? "" : ", ") + ("'" + label + "'") + " (" +
                 std::to_string(times.size()) + " images)";
    if (known.empty()) throw std::runtime_error(options.file + ": there are no images in it");
    const bool named = !options.sensor_label.empty();
    if (named && !contents.imageTimes.count(options.sensor_label))
        throw std::invalid_argument(options.file + ": no images labelled '" + options.sensor_label +
                                    "'; there are " + known);
    if (!named && contents.imageTimes.size() > 1)
        throw std::invalid_argument(options.file + ": images bear several labels: " + known +
                                    "; set [rawlog] sensor_label");
    return named ? options.sensor_label : contents.imageTimes.begin()->first;
}
}  // namespace

RawlogOptions RawlogOptions::from(ConfigSection section)
{
    constexpr double kMax = std::numeric_limits<int>::max();
    RawlogOptions o;
    o.file = section.get("file", o.file);
    o.sensor_label = section.get("sensor_label", o.sensor_label);
    o.first_frame = section.get("first_frame", o.first_frame, {0, kMax});
    o.frame_count = section.get("frame_count", o.frame_count, {0, kMax});
    o.every_nth = section.get("every_nth", o.every_nth, {1, kMax});
    o.stereo_side = section.get<StereoSide>(
        "stereo_side", o.stereo_side, {{"left", StereoSide::Left}, {"right", StereoSide::Right}});
    section.rejectUnknownKeys();
    return o;
}

RawlogReader::RawlogReader(RawlogOptions rawlog, CameraOptions camera)
    : rawlog_(std::move(rawlog)), cameraOptions_(std::move(camera))
{
    RawlogContents contents = scanRawlog(rawlog_.file, rawlog_.stereo_side);
    if (contents.imageTimes.empty() && !contents.damage.empty())
        throw std::runtime_error(contents.damage);
    rawlog_.sensor_label = chooseLabel(rawlog_, contents);
    groundTruth_ = std::move(contents.groundTruth);
    checkTimes(contents.imageTimes[rawlog_.sensor_label]);
    if (rawlog_.frame_count == 0 || frameCount_ < rawlog_.frame_count)
        damage_ = std::move(contents.damage);
    imagesFolder_ = imagesFolderOf(rawlog_.file);
    readCamera();
}

RawlogReader::~RawlogReader() = default;

void RawlogReader::fail(long index, const std::string& message) const
{
    throw std::runtime_error(rawlog_.file + ": frame " + std::to_string(index) + ": " + message);
}

bool RawlogReader::isSelected(long index) const
{
    const long offset = index - rawlog_.first_frame;
    return offset >= 0 && offset % rawlog_.every_nth == 0 &&
           (rawlog_.frame_count == 0 || offset / rawlog_.every_nth < rawlog_.frame_count);
}

void RawlogReader::checkTimes(const std::vector<Ticks>& times)
{
    std::vector<Ticks> selected;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        const long index = static_cast<long>(i);
        if (!isSelected(index)) continue;
        if (times[i] == ticksOf({})) fail(index, "has no timestamp");
        if (!selected.empty() && times[i] == selected.back())
            fail(index, "duplicate: the same time as the frame before it");
        if (!selected.empty() && times[i] < selected.back())
            fail(index, "time goes backwards by " +
                            std::to_string(seconds(selected.back() - times[i])) + " s");
        selected.push_back(times[i]);
    }
    if (selected.empty())
        throw std::invalid_argument(
            rawlog_.file + ": [rawlog] first_frame = " + std::to_string(rawlog_.first_frame) +
            " is beyond its " + std::to_string(times.size()) + " images");
    frameCount_ = static_cast<long>(selected.size());
    findGaps(selected);
}

void RawlogReader::findGaps(const std::vector<Ticks>& times)
{
    if (times.size() < 3) return;
    std::vector<Ticks> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    auto sorted = steps;
    const auto middle = sorted.begin() + static_cast<long>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
        if (2 * steps[i] <= 3 * *middle) continue;
        char line[120];
        std::snprintf(line, sizeof line, "%.4f s without a frame after t = %.7f s (median %.4f s)",
                      seconds(steps[i]), seconds(times[i]), seconds(*middle));
        gaps_.emplace_back(line);
    }
}

mrpt::obs::CObservation::Ptr RawlogReader::nextImage()
{
    if (yielded_ == frameCount_) return nullptr;
    while (auto observation = stream_->next())
    {
        if (observation->sensorLabel != rawlog_.sensor_label) continue;
        if (!imageOf(*observation, rawlog_.stereo_side)) continue;
        if (!isSelected(++index_)) continue;
        ++yielded_;
        return observation;
    }
    throw std::runtime_error(rawlog_.file + ": became shorter while it was read");
}

void RawlogReader::readCamera()
{
    stream_ = std::make_unique<ObservationStream>(rawlog_.file);
    const auto observation = nextImage();
    const auto recorded = imageOf(*observation, rawlog_.stereo_side);
    if (!cameraOptions_.calibration && !isCalibrated(*recorded->camera))
        fail(index_, "has no calibration; set [camera] source = ini");
    camera_ = cameraOptions_.choose(*recorded->camera);
    cameraPose_ = recorded->cameraPose;
    stream_ = std::make_unique<ObservationStream>(rawlog_.file);
    index_ = -1;
    yielded_ = 0;
}

std::optional<Frame> RawlogReader::next()
{
    const auto observation = nextImage();
    if (!observation && !damage_.empty()) throw std::runtime_error(damage_);
    if (!observation) return std::nullopt;
    const auto recorded = imageOf(*observation, rawlog_.stereo_side);
    if (!cameraOptions_.calibration && !isCalibrated(*recorded->camera))
        fail(index_, "has no calibration; set [camera] source = ini");
    Frame frame;
    frame.t_s = seconds(ticksOf(observation->timestamp));
    frame.index = index_;
    try
    {
        frame.image = toGrey(*recorded->image, imagesFolder_);
    }
    catch (const std::exception& e)
    {
        fail(index_, e.what());
    }
    if (frame.image.cols != camera_.width_px || frame.image.rows != camera_.height_px)
        fail(index_, "the image is " + sizeText(frame.image.cols, frame.image.rows) +
                         ", the calibration is for " +
                         sizeText(camera_.width_px, camera_.height_px));
    return frame;
}
}  // namespace monoslam
