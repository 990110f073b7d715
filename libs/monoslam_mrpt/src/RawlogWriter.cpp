// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RawlogWriter.h"

#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <regex>
#include <stdexcept>
#include <vector>

#include "monoslam_mrpt/CObservationPixelFeatures.h"
#include "monoslam_mrpt/RawlogContents.h"
#include "monoslam_mrpt/imageOf.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
[[noreturn]] void failToWrite(const std::string& file)
{
    throw std::runtime_error(file + ": cannot be written (disk full?)");
}

std::string lowerExtension(const std::string& file)
{
    std::string extension = fs::path(file).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".jpeg" ? ".jpg" : extension;
}

void savePng(const std::string& file, const cv::Mat& pixels)
{
    std::vector<unsigned char> bytes;
    cv::imencode(".png", pixels, bytes);
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) failToWrite(file);
}
}  // namespace

RawlogWriter::RawlogWriter(RawlogWriterOptions options) : options_(std::move(options))
{
    const fs::path file(options_.file);
    if (file.extension() != ".rawlog")
        throw std::invalid_argument(options_.file + ": the output must end in .rawlog");
    imagesFolder_ = (file.parent_path() / file.stem()).string() + "_Images";
    const bool occupied =
        fs::exists(file) || (fs::exists(imagesFolder_) && !fs::is_empty(imagesFolder_));
    if (occupied && !options_.force)
        throw std::runtime_error(options_.file + ": exists, or has images; use --force to replace");
    if (occupied) removeOldImages();
    std::error_code failed;
    if (!options_.embed) fs::create_directories(imagesFolder_, failed);
    if (failed) failToWrite(imagesFolder_);
    if (!stream_.open(options_.file)) failToWrite(options_.file);
}

RawlogWriter::~RawlogWriter()
{
    if (complete_) return;
    stream_.close();
    std::error_code ignored;
    if (fs::is_regular_file(options_.file, ignored)) fs::remove(options_.file, ignored);
}

void RawlogWriter::removeOldImages() const
{
    static const std::regex ours("[0-9]{6,}\\.(jpg|png)");
    if (!fs::is_directory(imagesFolder_)) return;
    for (const auto& entry : fs::directory_iterator(imagesFolder_))
        if (std::regex_match(entry.path().filename().string(), ours)) fs::remove(entry.path());
}

std::string RawlogWriter::nextImageName(const std::string& extension)
{
    char name[32];
    std::snprintf(name, sizeof name, "%06ld", images_);
    return name + extension;
}

void RawlogWriter::checkSize(const cv::Mat& pixels, const std::string& what) const
{
    const auto width = static_cast<int>(options_.camera.ncols);
    const auto height = static_cast<int>(options_.camera.nrows);
    if (pixels.cols == width && pixels.rows == height) return;
    throw std::runtime_error(what + ": the image is " + std::to_string(pixels.cols) + "x" +
                             std::to_string(pixels.rows) + ", the calibration is for " +
                             std::to_string(width) + "x" + std::to_string(height));
}

void RawlogWriter::write(mrpt::obs::CObservation& observation, Ticks t)
{
    observation.timestamp = clockOf(t);
    try
    {
        auto archive = mrpt::serialization::archiveFrom(stream_);
        archive << observation;
    }
    catch (const std::exception&)
    {
        failToWrite(options_.file);
    }
}

void RawlogWriter::writeImage(Ticks t, const std::string& externalName, const cv::Mat& pixels)
{
    mrpt::obs::CObservationImage observation;
    observation.sensorLabel = options_.sensorLabel;
    observation.cameraParams = options_.camera;
    observation.cameraPose = options_.cameraPose;
    if (options_.embed)
        observation.image = mrpt::img::CImage(pixels, mrpt::img::DEEP_COPY);
    else
        observation.image.setExternalStorage(externalName);
    write(observation, t);
    ++images_;
}

void RawlogWriter::addImageFile(Ticks t, const std::string& file)
{
    const cv::Mat grey = readGrey(file);
    checkSize(grey, file);
    const std::string extension = lowerExtension(file);
    const bool copied = extension == ".jpg" || extension == ".png";
    const std::string name = nextImageName(copied ? extension : ".png");
    const std::string target = imagesFolder_ + "/" + name;
    std::error_code failed;
    if (!options_.embed && copied)
        fs::copy_file(file, target, fs::copy_options::overwrite_existing, failed);
    if (failed) throw std::runtime_error(target + ": " + failed.message());
    if (!options_.embed && !copied) savePng(target, grey);
    writeImage(t, name, grey);
}

void RawlogWriter::addImage(Ticks t, const cv::Mat& pixels)
{
    checkSize(pixels, "frame " + std::to_string(images_));
    cv::Mat grey = pixels;
    if (pixels.channels() == 3) cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
    const std::string name = nextImageName(".png");
    if (!options_.embed) savePng(imagesFolder_ + "/" + name, grey);
    writeImage(t, name, grey);
}

void RawlogWriter::addFeatures(Ticks t, std::vector<PixelFeature> features)
{
    CObservationPixelFeatures observation;
    observation.sensorLabel = options_.sensorLabel;
    observation.cameraParams = options_.camera;
    observation.cameraPose = options_.cameraPose;
    observation.features = std::move(features);
    write(observation, t);
    ++featureFrames_;
}

void RawlogWriter::addTruth(Ticks t, const mrpt::poses::CPose3D& T_world_camera)
{
    mrpt::obs::CObservationRobotPose observation;
    observation.sensorLabel = "GT";
    observation.pose.mean = T_world_camera;
    observation.sensorPose = options_.cameraPose;
    write(observation, t);
    ++truths_;
}

void RawlogWriter::close()
{
    stream_.close();
    RawlogContents contents;
    try
    {
        contents = scanRawlog(options_.file);
    }
    catch (const std::exception&)
    {
        failToWrite(options_.file);
    }
    const auto written = static_cast<long>(contents.imageTimes[options_.sensorLabel].size());
    const char* features = CLASS_ID(CObservationPixelFeatures)->className;
    complete_ = contents.damage.empty() && written == images_ &&
                contents.classes[features] == featureFrames_ &&
                static_cast<long>(contents.groundTruth.size()) == truths_;
    if (!complete_) failToWrite(options_.file);
}
}  // namespace monoslam
