// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/cameraFrom.h"

#include <algorithm>
#include <stdexcept>

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
using mrpt::img::TCamera;
using MrptModel = mrpt::img::DistortionModel;

namespace
{
DistortionParameters distortionFrom(const TCamera& camera)
{
    DistortionParameters d;
    const auto isZero = [](double k) { return k == 0.0; };
    if (std::all_of(camera.dist.begin(), camera.dist.end(), isZero) &&
        camera.distortion != MrptModel::kannala_brandt)
        return d;
    if (camera.distortion == MrptModel::plumb_bob)
    {
        d.model = DistortionModel::Brown;
        d.k = camera.dist;
    }
    if (camera.distortion == MrptModel::kannala_brandt)
    {
        d.model = DistortionModel::KannalaBrandt;
        d.k = {camera.dist[0], camera.dist[1], camera.dist[4], camera.dist[5]};
    }
    return d;
}

DistortionParameters distortionFrom(ConfigSection& section)
{
    using M = DistortionModel;
    DistortionParameters d;
    d.model = section.get<M>("distortion_model", M::None,
                             {{"none", M::None},
                              {"brown", M::Brown},
                              {"kannala_brandt", M::KannalaBrandt},
                              {"tsai", M::Tsai},
                              {"davison", M::Davison}});
    const std::vector<double> k = section.get("distortion", std::vector<double>{});
    const auto fits = [&]
    {
        switch (d.model)
        {
            case M::Brown:
                return k.size() == 4 || k.size() == 5 || k.size() == 8;
            case M::KannalaBrandt:
                return k.size() == 4;
            case M::Tsai:
                return k.size() == 3;
            case M::Davison:
                return k.size() == 1;
            default:
                return true;
        }
    };
    if (!fits())
        section.fail("distortion",
                     "brown takes 4, 5 or 8 numbers, kannala_brandt 4, tsai 3 and "
                     "davison 1");
    if (d.model != M::None) std::copy(k.begin(), k.end(), d.k.begin());
    return d;
}
}  // namespace

bool isCalibrated(const TCamera& camera)
{
    return camera.fx() > 0 && camera.fy() > 0 && camera.ncols > 0 && camera.nrows > 0;
}

CameraParameters cameraFrom(const TCamera& camera)
{
    if (!isCalibrated(camera))
        throw std::invalid_argument("the camera is not calibrated (zero focal length)");
    CameraParameters p;
    p.width_px = static_cast<int>(camera.ncols);
    p.height_px = static_cast<int>(camera.nrows);
    p.fx_px = camera.fx();
    p.fy_px = camera.fy();
    p.cx_px = camera.cx();
    p.cy_px = camera.cy();
    p.distortion = distortionFrom(camera);
    return p;
}

TCamera toTCamera(const CameraParameters& camera)
{
    TCamera t;
    t.ncols = static_cast<unsigned>(camera.width_px);
    t.nrows = static_cast<unsigned>(camera.height_px);
    t.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
    const auto& k = camera.distortion.k;
    switch (camera.distortion.model)
    {
        case DistortionModel::None:
            break;
        case DistortionModel::Brown:
            t.distortion = MrptModel::plumb_bob;
            t.dist = k;
            break;
        case DistortionModel::KannalaBrandt:
            t.setDistortionKannalaBrandt(k[0], k[1], k[2], k[3]);
            break;
        default:
            throw std::invalid_argument("a rawlog cannot hold the distortion model " +
                                        name(camera.distortion.model) +
                                        "; use [camera] source = ini");
    }
    return t;
}

CameraOptions CameraOptions::from(ConfigSection section)
{
    CameraOptions o;
    CameraParameters p;
    const bool fromIni = section.get<bool>("source", false, {{"rawlog", false}, {"ini", true}});
    p.width_px = section.get("width_px", p.width_px, {16, 16384});
    p.height_px = section.get("height_px", p.height_px, {16, 16384});
    p.fx_px = section.get("fx_px", p.fx_px, {1, 1e6});
    p.fy_px = section.get("fy_px", p.fy_px, {1, 1e6});
    p.cx_px = section.get("cx_px", p.cx_px);
    p.cy_px = section.get("cy_px", p.cy_px);
    p.distortion = distortionFrom(section);
    o.readout_s = section.get("readout_s", o.readout_s, {0, 1});
    o.estimateReadout = section.get("estimate_readout", o.estimateReadout);
    section.rejectUnknownKeys();
    if (!fromIni) return o;
    for (const char* key : {"width_px", "height_px", "fx_px", "fy_px", "cx_px", "cy_px"})
        if (!section.has(key)) section.fail(key, "required with source = ini");
    o.calibration = p;
    return o;
}

CameraParameters CameraOptions::choose(const TCamera& recorded) const
{
    CameraParameters p = calibration ? *calibration : cameraFrom(recorded);
    p.readout_s = readout_s;
    return p;
}
}  // namespace monoslam
