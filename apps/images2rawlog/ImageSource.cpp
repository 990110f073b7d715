// SPDX-License-Identifier: BSD-3-Clause
#include "ImageSource.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <opencv2/videoio.hpp>
#include <set>
#include <stdexcept>

#include "TextTable.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
using Images = std::vector<SourceImage>;

Ticks ticksOfFrame(std::size_t index, double fps_hz)
{
    return static_cast<Ticks>(std::llround(static_cast<double>(index) * 1e7 / fps_hz));
}

std::vector<std::string> imageFilesIn(const fs::path& folder)
{
    static const std::set<std::string> known{".jpg", ".jpeg", ".png", ".pgm",
                                             ".bmp", ".tif",  ".tiff"};
    if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": no such folder");
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder))
    {
        std::string extension = entry.path().extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(), ::tolower);
        if (known.count(extension)) files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) throw std::runtime_error(folder.string() + ": there are no images in it");
    return files;
}

/** Lines "time file" with paths relative to `base`. */
Images readList(const fs::path& list, const fs::path& base,
                std::optional<Ticks> (*parse)(const std::string&))
{
    Images images;
    for (const auto& row : readTable(list.string()))
    {
        if (row.words.size() < 2) row.fail("expected a time and a file name");
        const auto t = parse(row.words[0]);
        if (!t) row.fail("not a time: " + row.words[0]);
        images.push_back({*t, (base / row.words[1]).string(), {}});
    }
    if (images.empty()) throw std::runtime_error(list.string() + ": lists no images");
    return images;
}

Images readTum(const fs::path& input)
{
    return readList(input / "rgb.txt", input, parseSeconds);
}

Images readEuroc(const fs::path& input)
{
    const fs::path folder = fs::exists(input / "data.csv") ? input
                            : fs::exists(input / "cam0")   ? input / "cam0"
                                                           : input / "mav0" / "cam0";
    return readList(folder / "data.csv", folder / "data", parseNanoseconds);
}

Images readKitti(const fs::path& input)
{
    const auto files = imageFilesIn(input / "image_0");
    const fs::path list = input / "times.txt";
    const auto rows = readTable(list.string());
    if (rows.size() != files.size())
        throw std::runtime_error(list.string() + ": " + std::to_string(rows.size()) +
                                 " times for " + std::to_string(files.size()) + " images");
    Images images;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const auto t = parseSeconds(rows[i].words[0]);
        if (!t) rows[i].fail("not a time: " + rows[i].words[0]);
        images.push_back({*t, files[i], {}});
    }
    return images;
}

Images readFolder(const fs::path& input, double fps_hz)
{
    if (!(fps_hz > 0)) throw std::invalid_argument("--format folder needs --fps");
    Images images;
    for (const auto& file : imageFilesIn(input))
        images.push_back({ticksOfFrame(images.size(), fps_hz), file, {}});
    return images;
}

ImageSource over(Images images)
{
    return [images = std::move(images), i = std::size_t{0}]() mutable -> std::optional<SourceImage>
    {
        if (i == images.size()) return std::nullopt;
        return images[i++];
    };
}

/** With --fps, equal steps; else the container's own times, which of a phone are uneven. */
ImageSource overVideo(const SourceOptions& options)
{
    if (!fs::is_regular_file(options.input))
        throw std::runtime_error(options.input + ": no such video");
    auto video = std::make_shared<cv::VideoCapture>(options.input);
    if (!video->isOpened()) throw std::runtime_error(options.input + ": cannot be decoded");
    const double containerFps_hz = video->get(cv::CAP_PROP_FPS);
    return [=, i = std::size_t{0}, last = Ticks{-1}]() mutable -> std::optional<SourceImage>
    {
        SourceImage image;
        if (!video->read(image.pixels)) return std::nullopt;
        image.pixels = image.pixels.clone();
        image.t = static_cast<Ticks>(std::llround(video->get(cv::CAP_PROP_POS_MSEC) * 1e4));
        if (options.fps_hz > 0)
            image.t = ticksOfFrame(i, options.fps_hz);
        else if (image.t <= last && containerFps_hz > 0)
            image.t = last + ticksOfFrame(1, containerFps_hz);
        last = image.t;
        ++i;
        return image;
    };
}
}  // namespace

const std::vector<std::string>& sourceFormats()
{
    static const std::vector<std::string> formats{"tum", "euroc", "kitti", "folder", "video"};
    return formats;
}

ImageSource openSource(const SourceOptions& options)
{
    if (options.format == "video") return overVideo(options);
    if (!fs::is_directory(options.input))
        throw std::runtime_error(options.input + ": no such folder");
    if (options.format == "tum") return over(readTum(options.input));
    if (options.format == "euroc") return over(readEuroc(options.input));
    if (options.format == "kitti") return over(readKitti(options.input));
    return over(readFolder(options.input, options.fps_hz));
}
}  // namespace monoslam
