// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include <cstdio>
#include <stdexcept>

#include "monoslam_mrpt/RawlogWriter.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "readTruth.h"

namespace monoslam
{
namespace
{
void warnOfIgnoredKeys(const ConvertOptions& options, const CameraFile& file)
{
    if (file.ignoredKeys.empty()) return;
    std::string keys;
    for (const auto& key : file.ignoredKeys) keys += " " + key;
    std::fprintf(stderr, "images2rawlog: warning: %s: ignored:%s\n", options.cameraFile.c_str(),
                 keys.c_str());
}

/** KITTI's poses have no times of their own. */
std::vector<Ticks> timesOfAll(const SourceOptions& source)
{
    std::vector<Ticks> times;
    if (source.format == "video") return times;
    const ImageSource images = openSource(source);
    while (const auto image = images()) times.push_back(image->t);
    return times;
}

void checkTime(Ticks t, std::optional<Ticks> last, long frame)
{
    if (!last || t > *last) return;
    throw std::runtime_error(
        "frame " + std::to_string(frame) + ": " +
        (t == *last ? "duplicate: the same time as the frame before it" : "time goes backwards"));
}
}  // namespace

void convert(const ConvertOptions& options)
{
    const CameraFile calibration = readCameraFile(options.cameraFile);
    warnOfIgnoredKeys(options, calibration);
    const ImageSource images = openSource(options.source);
    std::vector<RecordedPose> truth;
    if (!options.truthFile.empty())
        truth = readTruth(options.truthFile, calibration.cameraPose, timesOfAll(options.source));

    RawlogWriter rawlog({options.output, options.embed, options.force,
                         toTCamera(calibration.camera), calibration.cameraPose});
    auto pose = truth.begin();
    std::optional<Ticks> last;
    long frames = 0;
    while (const auto image = images())
    {
        checkTime(image->t, last, frames);
        last = image->t;
        for (; pose != truth.end() && pose->t <= image->t; ++pose)
            rawlog.addTruth(pose->t, pose->pose);
        if (image->pixels.empty())
            rawlog.addImageFile(image->t, image->file);
        else
            rawlog.addImage(image->t, image->pixels);
        ++frames;
    }
    if (frames == 0) throw std::runtime_error(options.source.input + ": no frame can be decoded");
    for (; pose != truth.end(); ++pose) rawlog.addTruth(pose->t, pose->pose);
    rawlog.close();
    std::printf("%s: %ld images, %zu poses of truth\n", options.output.c_str(), frames,
                truth.size());
}
}  // namespace monoslam
