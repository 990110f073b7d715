// SPDX-License-Identifier: BSD-3-Clause
#include "readRecordedParts.h"

#include <algorithm>
#include <limits>

#include "recordedFrameNames.h"

namespace monoslam
{
namespace
{
DistortionParameters distortionFrom(const JsonValue& value)
{
    value.expectKeys({"model", "k"});
    DistortionParameters distortion;
    const std::string model = value["model"].text();
    bool found = false;
    for (const DistortionModel known : kDistortionModels)
    {
        if (name(known) != model) continue;
        distortion.model = known;
        found = true;
    }
    if (!found) value["model"].fail("unknown " + model);
    const Eigen::VectorXd k = value["k"].vector(static_cast<Eigen::Index>(distortion.k.size()));
    std::copy(k.begin(), k.end(), distortion.k.begin());
    return distortion;
}
}  // namespace

int smallNumber(const JsonValue& value)
{
    const std::int64_t number = value.whole();
    if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
        value.fail("is out of range");
    return static_cast<int>(number);
}

Camera readCamera(const JsonValue& value)
{
    value.expectKeys(
        {"width_px", "height_px", "fx_px", "fy_px", "cx_px", "cy_px", "distortion", "readout_s"});
    CameraParameters p;
    p.width_px = smallNumber(value["width_px"]);
    p.height_px = smallNumber(value["height_px"]);
    p.fx_px = value["fx_px"].number();
    p.fy_px = value["fy_px"].number();
    p.cx_px = value["cx_px"].number();
    p.cy_px = value["cy_px"].number();
    p.distortion = distortionFrom(value["distortion"]);
    p.readout_s = value["readout_s"].number();
    try
    {
        return Camera(p);
    }
    catch (const std::exception& error)
    {
        value.fail(error.what());
    }
}

WeightedBelief readBelief(const JsonValue& value)
{
    value.expectKeys({"log_weight", "separation", "landmarks", "clones", "x", "P"});
    WeightedBelief weighted;
    weighted.logWeight = value["log_weight"].number();
    for (const JsonValue& frames : value["separation"].list())
        weighted.separation.push_back(frames.whole());
    Belief& belief = weighted.belief;
    for (const JsonValue& slot : value["landmarks"].list())
    {
        slot.expectKeys({"id", "kind", "offset"});
        belief.landmarks.push_back({slot["id"].whole(), namedValue(kKindNames, slot["kind"]),
                                    static_cast<Eigen::Index>(slot["offset"].whole())});
    }
    for (const JsonValue& slot : value["clones"].list())
    {
        slot.expectKeys({"id", "offset"});
        belief.clones.push_back(
            {slot["id"].whole(), static_cast<Eigen::Index>(slot["offset"].whole())});
    }
    belief.x = value["x"].vector();
    if (belief.size() < camera_state::kSize) value["x"].fail("is shorter than a camera's state");
    belief.P = value["P"].matrix(belief.size(), belief.size());
    try
    {
        belief.checkInvariant();
    }
    catch (const std::logic_error& error)
    {
        value.fail(error.what());
    }
    return weighted;
}
}  // namespace monoslam
