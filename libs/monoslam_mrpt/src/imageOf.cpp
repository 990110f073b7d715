// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/imageOf.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace monoslam
{
using namespace mrpt::obs;
using mrpt::poses::CPose3D;

namespace
{
using Bytes = std::vector<unsigned char>;

Bytes readBytes(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("image " + file + " is missing");
    return {std::istreambuf_iterator<char>(stream), {}};
}

/** A JPEG whose last image has no end: libjpeg would only warn, and fill up with grey. */
bool isTruncatedJpeg(const Bytes& bytes)
{
    constexpr std::array<unsigned char, 2> start{0xff, 0xd8}, scan{0xff, 0xda}, end{0xff, 0xd9};
    if (bytes.size() < 4 || !std::equal(start.begin(), start.end(), bytes.begin())) return false;
    const auto lastOf = [&](const std::array<unsigned char, 2>& marker)
    { return std::find_end(bytes.begin(), bytes.end(), marker.begin(), marker.end()); };
    const auto lastEnd = lastOf(end);
    return lastEnd == bytes.end() || lastEnd < lastOf(scan);
}

cv::Mat convertToGrey(const cv::Mat& image)
{
    if (image.type() == CV_8UC1) return image.clone();
    cv::Mat grey;
    if (image.type() == CV_8UC3)
        cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    else if (image.type() == CV_8UC4)
        cv::cvtColor(image, grey, cv::COLOR_BGRA2GRAY);
    else if (image.type() == CV_16UC1)
        image.convertTo(grey, CV_8U, 1.0 / 256.0);
    else
        throw std::runtime_error("embedded image has an unknown pixel type");
    return grey;
}
}  // namespace

std::optional<RecordedImage> imageOf(const CObservation& observation, StereoSide side)
{
    if (const auto* mono = dynamic_cast<const CObservationImage*>(&observation))
        return RecordedImage{&mono->image, &mono->cameraParams, mono->cameraPose};
    if (const auto* stereo = dynamic_cast<const CObservationStereoImages*>(&observation))
    {
        const CPose3D left(stereo->cameraPose);
        if (side == StereoSide::Left)
            return RecordedImage{&stereo->imageLeft, &stereo->leftCamera, left};
        if (stereo->hasImageRight)
            return RecordedImage{&stereo->imageRight, &stereo->rightCamera,
                                 left + CPose3D(stereo->rightCameraPose)};
    }
    const auto* range = dynamic_cast<const CObservation3DRangeScan*>(&observation);
    if (range != nullptr && range->hasIntensityImage)
        return RecordedImage{&range->intensityImage, &range->cameraParamsIntensity,
                             range->sensorPose + range->relativePoseIntensityWRTDepth};
    return std::nullopt;
}

cv::Mat readGrey(const std::string& file)
{
    const Bytes bytes = readBytes(file);
    cv::Mat image;
    if (!bytes.empty() && !isTruncatedJpeg(bytes))
        image = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
    if (image.empty()) throw std::runtime_error("image " + file + " cannot be decoded");
    return image;
}

std::string imagesFolderOf(const std::string& rawlogFile)
{
    const std::filesystem::path file(rawlogFile);
    const auto folder = file.parent_path();
    for (const char* ending : {"_Images", "_images", "_IMAGES"})
        if (const auto path = folder / (file.stem().string() + ending);
            std::filesystem::is_directory(path))
            return path.string();
    return (folder / "Images").string();
}

cv::Mat toGrey(const mrpt::img::CImage& image, const std::string& imagesFolder)
{
    if (image.isExternallyStored())
        return readGrey(std::filesystem::path(imagesFolder) / image.getExternalStorageFile());
    if (image.isEmpty()) throw std::runtime_error("embedded image is empty");
    return convertToGrey(image.asCvMatRef());
}
}  // namespace monoslam
