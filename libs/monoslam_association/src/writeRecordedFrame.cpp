// SPDX-License-Identifier: BSD-3-Clause
#include "JsonValue.h"
#include "monoslam_association/recordedFrameFile.h"
#include "recordedFrameNames.h"

namespace monoslam
{
namespace
{
/** What is longer is broken, but for a list of numbers. */
constexpr std::size_t kLineLength = 120;

template <typename Names, typename Value>
const char* nameOf(const Names& names, Value value)
{
    for (const auto& entry : names)
        if (entry.second == value) return entry.first;
    throw std::logic_error("recorded frame: a value without a name");
}

Json cameraToJson(const Camera& camera)
{
    const CameraParameters& c = camera.parameters();
    return {{"width_px", c.width_px},
            {"height_px", c.height_px},
            {"fx_px", c.fx_px},
            {"fy_px", c.fy_px},
            {"cx_px", c.cx_px},
            {"cy_px", c.cy_px},
            {"distortion", {{"model", name(c.distortion.model)}, {"k", c.distortion.k}}},
            {"readout_s", c.readout_s}};
}

Json beliefToJson(const WeightedBelief& weighted)
{
    const Belief& belief = weighted.belief;
    Json landmarks = Json::array(), clones = Json::array();
    for (const LandmarkSlot& slot : belief.landmarks)
        landmarks.push_back(
            {{"id", slot.id}, {"kind", nameOf(kKindNames, slot.kind)}, {"offset", slot.offset}});
    for (const CloneSlot& slot : belief.clones)
        clones.push_back({{"id", slot.id}, {"offset", slot.offset}});
    return {{"log_weight", weighted.logWeight}, {"separation", weighted.separation},
            {"landmarks", landmarks},           {"clones", clones},
            {"x", numbersToJson(belief.x)},     {"P", rowsToJson(belief.P)}};
}

Json landmarkToJson(const RecordedLandmark& landmark)
{
    Json json{{"id", landmark.id}, {"status", nameOf(kStatusNames, landmark.status)}};
    json["truth"] = landmark.truth ? Json(*landmark.truth) : Json();
    json["candidates"] = Json::array();
    for (const Candidate& candidate : landmark.candidates)
        json["candidates"].push_back({{"z", numbersToJson(candidate.z)},
                                      {"score", candidate.score},
                                      {"R", rowsToJson(candidate.R)}});
    json["predicted"] = Json();
    if (!landmark.predicted) return json;
    const PredictedLandmark& row = *landmark.predicted;
    json["predicted"] = {{"h", numbersToJson(row.h)},
                         {"H_v", rowsToJson(row.H_v)},
                         {"H_y", rowsToJson(row.H_y.leftCols(row.size))},
                         {"S", rowsToJson(row.S)}};
    return json;
}

void layOut(const Json& value, const std::string& indent, std::string& text)
{
    const std::string flat = value.dump();
    const bool numbers = value.is_array() && !value.empty() && !value.front().is_structured();
    if (!value.is_structured() || numbers || indent.size() + flat.size() < kLineLength)
    {
        text += flat;
        return;
    }
    const std::string inner = indent + " ";
    text += value.is_object() ? "{" : "[";
    const char* separator = "\n";
    for (const auto& entry : value.items())
    {
        text += separator + inner;
        if (value.is_object()) text += Json(entry.key()).dump() + ": ";
        layOut(entry.value(), inner, text);
        separator = ",\n";
    }
    text += "\n" + indent + (value.is_object() ? "}" : "]");
}
}  // namespace

std::string toText(const RecordedFrame& frame)
{
    Json json{{"format", kFormatName}, {"version", kFormatVersion}, {"frame", frame.index}};
    json["camera"] = cameraToJson(frame.camera);
    json["visibility"] = {{"border_px", frame.visibility.border_px},
                          {"sigma_px", frame.visibility.sigma_px}};
    json["min_score"] = frame.minScore;
    json["limits"] = {{"gate", frame.limits.gate},
                      {"min_score", frame.limits.minScore},
                      {"max_candidates", frame.limits.maxCandidates}};
    json["landmarks"] = Json::array();
    for (const RecordedLandmark& landmark : frame.landmarks)
        json["landmarks"].push_back(landmarkToJson(landmark));
    json["beliefs"] = Json::array();
    for (const WeightedBelief& weighted : frame.mixture)
        json["beliefs"].push_back(beliefToJson(weighted));
    std::string text;
    layOut(json, {}, text);
    return text + "\n";
}
}  // namespace monoslam
