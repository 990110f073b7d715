// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "monoslam_mrpt/RawlogWriter.h"
#include "monoslam_mrpt/cameraFrom.h"

/** A small rawlog of a textured plane that slides through a 160 x 120 image. */
namespace monoslam
{
inline constexpr Ticks kExampleStart = 13050312295287480;  // 1305031229.528748 s
inline constexpr Ticks kExampleStep = 333333;

inline CameraParameters exampleRawlogCamera()
{
    CameraParameters p;
    p.width_px = 160;
    p.height_px = 120;
    p.fx_px = p.fy_px = 130.0;
    p.cx_px = 79.5;
    p.cy_px = 59.5;
    return p;
}

inline cv::Mat exampleImage(int index)
{
    cv::Mat noise(140, 400, CV_8UC1), image;
    cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(noise, image, {}, 1.5);
    cv::normalize(image, image, 10, 245, cv::NORM_MINMAX);
    return image(cv::Rect(2 * index, 10, 160, 120)).clone();
}

inline std::vector<Ticks> exampleTimes(int count)
{
    std::vector<Ticks> times;
    for (int i = 0; i < count; ++i) times.push_back(kExampleStart + i * kExampleStep);
    return times;
}

/** \param embed  images inside the file */
inline void writeExampleRawlog(const std::string& file, const std::vector<Ticks>& times,
                               bool embed = false)
{
    RawlogWriterOptions options;
    options.file = file;
    options.embed = embed;
    options.camera = toTCamera(exampleRawlogCamera());
    RawlogWriter writer(options);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        writer.addTruth(times[i], mrpt::poses::CPose3D(0.01 * static_cast<double>(i), 0, 0));
        writer.addImage(times[i], exampleImage(static_cast<int>(i)));
    }
    writer.close();
}
}  // namespace monoslam
