// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFile.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "YamlKeys.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
using mrpt::containers::yaml;

namespace
{
[[noreturn]] void fail(const std::string& path, const std::string& message)
{
    throw std::invalid_argument(path + ": " + message);
}

DistortionParameters brown(const std::vector<double>& k)
{
    DistortionParameters d;
    for (std::size_t i = 0; i < std::min(k.size(), d.k.size()); ++i) d.k[i] = k[i];
    for (const double value : k)
        if (value != 0) d.model = DistortionModel::Brown;
    return d;
}

CameraFile readPlainYaml(YamlKeys keys)
{
    CameraFile file;
    auto& p = file.camera;
    p.width_px = static_cast<int>(keys.number("width"));
    p.height_px = static_cast<int>(keys.number("height"));
    p.fx_px = keys.number("fx");
    p.fy_px = keys.number("fy");
    p.cx_px = keys.number("cx");
    p.cy_px = keys.number("cy");
    std::vector<double> k;
    for (const char* key : {"k1", "k2", "p1", "p2", "k3"}) k.push_back(keys.number(key, 0.0));
    p.distortion = brown(k);
    file.ignoredKeys = keys.ignored();
    return file;
}

mrpt::poses::CPose3D poseOf(const std::vector<double>& T)
{
    mrpt::math::CMatrixDouble44 H;
    for (int row = 0; row < 4; ++row)
        for (int col = 0; col < 4; ++col) H(row, col) = T[static_cast<std::size_t>(4 * row + col)];
    return mrpt::poses::CPose3D(H);
}

CameraFile readEurocYaml(YamlKeys keys, const std::string& path)
{
    CameraFile file;
    auto& p = file.camera;
    const auto size = keys.numbers("resolution", 2);
    const auto f = keys.numbers("intrinsics", 4);
    const std::string model = keys.text("distortion_model", "none");
    p.width_px = static_cast<int>(size[0]);
    p.height_px = static_cast<int>(size[1]);
    p.fx_px = f[0];
    p.fy_px = f[1];
    p.cx_px = f[2];
    p.cy_px = f[3];
    if (model == "radial-tangential" || model == "radtan" || model == "plumb_bob")
        p.distortion = brown(keys.numbers("distortion_coefficients", 4));
    else if (model == "equidistant" || model == "kannala_brandt")
    {
        const auto k = keys.numbers("distortion_coefficients", 4);
        p.distortion = {DistortionModel::KannalaBrandt, {k[0], k[1], k[2], k[3]}};
    }
    else if (model != "none")
        fail(path, "key distortion_model: unknown model " + model);
    if (keys.has("T_BS"))
    {
        const yaml T = keys.child("T_BS");
        file.cameraPose = poseOf(YamlKeys(T, path + ": T_BS").numbers("data", 16));
    }
    file.ignoredKeys = keys.ignored();
    return file;
}

CameraFile readYaml(const std::string& path)
{
    yaml root;
    try
    {
        root = yaml::FromFile(path);
    }
    catch (const std::exception&)
    {
        fail(path, "not a yaml file");
    }
    if (!root.isMap()) fail(path, "not a yaml map");
    if (root.has("intrinsics")) return readEurocYaml({root, path}, path);
    return readPlainYaml({root, path});
}

CameraFile readIni(const std::string& path)
{
    const mrpt::config::CConfigFile ini(path);
    if (ini.sectionExists("camera"))
    {
        const auto options = CameraOptions::from(ConfigSection(ini, "camera", path));
        if (!options.calibration) fail(path, "[camera] source: must be ini in a calibration file");
        return {*options.calibration, {}, {}};
    }
    std::vector<std::string> sections;
    ini.getAllSections(sections);
    for (const auto& section : sections)
    {
        if (!ini.keyExists(section, "resolution")) continue;
        mrpt::img::TCamera camera;
        try
        {
            camera.loadFromConfigFile(section, ini);
        }
        catch (const std::exception& e)
        {
            fail(path, "[" + section + "]: " + e.what());
        }
        std::vector<double> k;
        ini.read_vector(section, "dist", k, k);
        if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt && k.size() == 4)
            camera.setDistortionKannalaBrandt(k[0], k[1], k[2], k[3]);  // MRPT puts k3, k4 wrong
        return {cameraFrom(camera), {}, {}};
    }
    fail(path, "no section with a resolution: not a camera calibration");
}
}  // namespace

CameraFile readCameraFile(const std::string& path)
{
    if (!std::filesystem::is_regular_file(path)) fail(path, "no such calibration file");
    const auto extension = std::filesystem::path(path).extension();
    CameraFile file = extension == ".ini" || extension == ".cfg" ? readIni(path) : readYaml(path);
    try
    {
        Camera usable(file.camera);
    }
    catch (const std::exception& e)
    {
        fail(path, e.what());
    }
    return file;
}
}  // namespace monoslam
