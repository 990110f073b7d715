// SPDX-License-Identifier: BSD-3-Clause
#include "ObjectPolygons.h"

#include <Eigen/Core>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

namespace monoslam
{
namespace
{
/** The numbers of every line but the time stamp. */
std::vector<std::vector<double>> readLines(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    std::vector<std::vector<double>> lines;
    for (std::string line; std::getline(stream, line);)
    {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream fields(line);
        double number = 0.0;
        fields >> number;
        std::vector<double> numbers;
        while (fields >> number) numbers.push_back(number);
        if (numbers.size() < 6) throw std::runtime_error(file + ": bad line: " + line);
        lines.push_back(numbers);
    }
    return lines;
}
}  // namespace

bool ObjectPolygons::contains(long frame, double u, double v) const
{
    const auto& outline = outlines.at(static_cast<std::size_t>(frame));
    const cv::Point2f pixel(static_cast<float>(u), static_cast<float>(v));
    return cv::pointPolygonTest(outline, pixel, false) >= 0;
}

ObjectPolygons readObjectPolygons(const std::string& folder)
{
    ObjectPolygons polygons;
    for (const auto& numbers : readLines(folder + "/object_polygon.txt"))
    {
        std::vector<cv::Point2f> outline;
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            outline.emplace_back(static_cast<float>(numbers[i]),
                                 static_cast<float>(numbers[i + 1]));
        polygons.outlines.push_back(outline);
    }
    const auto motion = readLines(folder + "/object_motion.txt");
    for (const auto& pose : motion)
    {
        const Eigen::Vector3d moved(pose[0] - motion[0][0], pose[1] - motion[0][1],
                                    pose[2] - motion[0][2]);
        if (moved.norm() > 1e-6) break;
        ++polygons.firstMoving;
    }
    return polygons;
}
}  // namespace monoslam
