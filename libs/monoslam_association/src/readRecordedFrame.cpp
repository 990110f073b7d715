// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <sstream>

#include "JsonValue.h"
#include "monoslam_association/recordedFrameFile.h"
#include "readRecordedParts.h"
#include "recordedFrameNames.h"

namespace monoslam
{
namespace
{
PredictedLandmark predictedFrom(const JsonValue& value, LandmarkId id, const RecordedFrame& frame)
{
    value.expectKeys({"h", "H_v", "H_y", "S"});
    const Belief& belief = best(frame.mixture);
    const Eigen::Index at = belief.find(id);
    if (at < 0) value.fail("the belief has no landmark " + std::to_string(id));
    PredictedLandmark row;
    row.id = id;
    row.offset = belief.landmarks[static_cast<std::size_t>(at)].offset;
    row.size = belief.landmarks[static_cast<std::size_t>(at)].size();
    row.h = value["h"].vector(2);
    row.H_v = value["H_v"].matrix(2, camera_state::kSize);
    row.H_y.setZero();
    row.H_y.leftCols(row.size) = value["H_y"].matrix(2, row.size);
    row.S = value["S"].matrix(2, 2);
    row.R = frame.visibility.sigma_px * frame.visibility.sigma_px * Eigen::Matrix2d::Identity();
    return row;
}

RecordedLandmark landmarkFrom(const JsonValue& value, const RecordedFrame& frame)
{
    value.expectKeys({"id", "status", "truth", "candidates", "predicted"});
    RecordedLandmark landmark;
    landmark.id = value["id"].whole();
    landmark.status = namedValue(kStatusNames, value["status"]);
    for (const JsonValue& candidate : value["candidates"].list())
    {
        candidate.expectKeys({"z", "score", "R"});
        landmark.candidates.push_back(
            {candidate["z"].vector(2), candidate["score"].number(), candidate["R"].matrix(2, 2)});
    }
    if (!value["truth"].isNull()) landmark.truth = smallNumber(value["truth"]);
    if (landmark.truth &&
        (*landmark.truth < -1 || *landmark.truth >= static_cast<int>(landmark.candidates.size())))
        value["truth"].fail("is neither -1 nor the index of a candidate");
    if (!value["predicted"].isNull())
        landmark.predicted = predictedFrom(value["predicted"], landmark.id, frame);
    return landmark;
}

void expectFormat(const JsonValue& file)
{
    if (file["format"].text() != kFormatName)
        file["format"].fail("is not \"" + std::string(kFormatName) + "\"");
    if (file["version"].whole() != kFormatVersion)
        file["version"].fail("only version " + std::to_string(kFormatVersion) + " is known");
    file.expectKeys({"format", "version", "frame", "camera", "visibility", "min_score", "limits",
                     "landmarks", "beliefs"});
}

RecordedFrame frameFrom(const JsonValue& file)
{
    expectFormat(file);
    RecordedFrame frame;
    frame.index = file["frame"].whole();
    frame.camera = readCamera(file["camera"]);
    const JsonValue visibility = file["visibility"];
    visibility.expectKeys({"border_px", "sigma_px"});
    frame.visibility = {visibility["border_px"].number(), visibility["sigma_px"].number()};
    frame.minScore = file["min_score"].number();
    const JsonValue limits = file["limits"];
    limits.expectKeys({"gate", "min_score", "max_candidates"});
    frame.limits = {limits["gate"].number(), limits["min_score"].number(),
                    smallNumber(limits["max_candidates"])};
    for (const JsonValue& belief : file["beliefs"].list())
        frame.mixture.push_back(readBelief(belief));
    if (frame.mixture.empty()) file["beliefs"].fail("is empty");
    for (const JsonValue& landmark : file["landmarks"].list())
        frame.landmarks.push_back(landmarkFrom(landmark, frame));
    return frame;
}
}  // namespace

RecordedFrame recordedFrameFromText(const std::string& text, const std::string& fileName)
{
    Json json;
    try
    {
        json = Json::parse(text);
    }
    catch (const Json::parse_error& error)
    {
        throw std::invalid_argument(fileName + ": not an association problem, or cut off: byte " +
                                    std::to_string(error.byte) + " of " +
                                    std::to_string(text.size()) + " is not JSON");
    }
    RecordedFrame frame = frameFrom(JsonValue(json, fileName));
    try
    {
        frame.check();
    }
    catch (const std::invalid_argument& error)
    {
        throw std::invalid_argument(fileName + ": " + error.what());
    }
    return frame;
}

RecordedFrame readRecordedFrame(const std::string& fileName)
{
    std::error_code ignored;
    std::ifstream stream(fileName);
    if (!stream || std::filesystem::is_directory(fileName, ignored))
        throw std::runtime_error(fileName + ": no such association problem");
    std::ostringstream text;
    text << stream.rdbuf();
    return recordedFrameFromText(text.str(), fileName);
}
}  // namespace monoslam
