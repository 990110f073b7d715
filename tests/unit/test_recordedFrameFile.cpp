// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/recordedFrameFile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TemporaryFolder.h"
#include "recordedFrames.h"

namespace monoslam::test
{
namespace
{
/** The error of a file in which \p from is replaced by \p to. */
std::string errorOf(const std::string& from, const std::string& to)
{
    std::string text = toText(exampleFrame());
    const auto at = text.find(from);
    if (at == std::string::npos) return "not in the file: " + from;
    text.replace(at, from.size(), to);
    try
    {
        static_cast<void>(recordedFrameFromText(text, "bug.json"));
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "none";
}

void expectError(const std::string& error, const std::vector<std::string>& words)
{
    EXPECT_EQ(error.rfind("bug.json: ", 0), 0U) << error;
    for (const std::string& word : words)
        EXPECT_NE(error.find(word), std::string::npos) << word << " not in: " << error;
}
}  // namespace

TEST(RecordedFrameFile, KeepsEverything)
{
    RecordedFrame frame = exampleFrame();
    frame.mixture.push_back(frame.mixture.front());
    frame.mixture.back().logWeight = -0.1;
    for (WeightedBelief& weighted : frame.mixture) weighted.separation = {3, 4};
    frame.landmarks[2].status = SearchStatus::Refused;
    frame.limits.maxCandidates = 7;
    const std::string text = toText(frame);
    const RecordedFrame read = recordedFrameFromText(text, "bug.json");
    EXPECT_EQ(toText(read), text);
    EXPECT_EQ(read.index, 17);
    EXPECT_EQ(read.mixture[1].separation, frame.mixture[1].separation);
    EXPECT_EQ(read.mixture[0].belief.clones.size(), 1U);
    EXPECT_EQ(read.landmarks[0].truth, 0);
    EXPECT_EQ(read.landmarks[1].truth, -1);
    EXPECT_FALSE(read.landmarks[3].truth);
    EXPECT_EQ(read.camera.parameters().distortion.model, DistortionModel::Brown);
}

TEST(RecordedFrameFile, NamesWhatIsWrongWithIt)
{
    expectError(errorOf("problem\"", "puzzle\""), {"format"});
    expectError(errorOf("\"version\": 1", "\"version\": 2"), {"version", "1"});
    expectError(errorOf("\"min_score\": 0.7", "\"min_scroe\": 0.7"), {"min_scroe"});
    expectError(errorOf(" \"min_score\": 0.7,\n", ""), {"min_score", "missing"});
    expectError(errorOf("\"min_score\": 0.7", "\"min_score\": \"0.7\""), {"min_score", "number"});
    expectError(errorOf("\"width_px\": 640", "\"width_px\": 64.5"), {"camera: width_px", "whole"});
    expectError(errorOf("\"width_px\": 640", "\"width_px\": -4"), {"camera"});
    expectError(errorOf("\"model\":\"brown\"", "\"model\":\"green\""), {"distortion", "green"});
    expectError(errorOf("inverse_depth", "depth"), {"beliefs[0]: landmarks[", "kind", "depth"});
    expectError(errorOf("\"truth\": 0", "\"truth\": 9"), {"landmarks[0]: truth"});
    expectError(errorOf("\"x\": [", "\"x\": [1.0,"), {"beliefs[0]: P", "rows"});
    expectError(errorOf("\"x\": [", "\"x\": [null,"), {"beliefs[0]: x"});
    expectError(errorOf("\"status\": \"done\"", "\"status\": 3"), {"landmarks[0]: status", "text"});
}

TEST(RecordedFrameFile, IsRefusedWhereverItIsCutOff)
{
    const std::string text = toText(exampleFrame());
    for (std::size_t length = 0; length + 2 < text.size(); length += 997)
    {
        try
        {
            static_cast<void>(recordedFrameFromText(text.substr(0, length), "bug.json"));
            FAIL() << "read " << length << " of " << text.size();
        }
        catch (const std::invalid_argument& error)
        {
            expectError(error.what(), {"cut off"});
        }
    }
}

TEST(RecordedFrameFile, IsRefusedIfBeliefAndCameraDoNotPredictIt)
{
    expectError(errorOf("\"cx_px\": 3", "\"cx_px\": 2"), {"landmark", "h is not what"});
    RecordedFrame frame = exampleFrame();
    const auto messageOf = [&frame](auto&& spoil)
    {
        RecordedFrame spoiled = frame;
        spoil(*spoiled.landmarks[3].predicted);
        try
        {
            spoiled.check();
        }
        catch (const std::invalid_argument& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string id = "landmark " + std::to_string(frame.landmarks[3].id) + ": ";
    EXPECT_EQ(messageOf([](PredictedLandmark&) {}), "");
    EXPECT_EQ(messageOf([](PredictedLandmark& p) { p.H_v(0, 1) += 0.1; }).rfind(id + "H_v", 0), 0U);
    EXPECT_EQ(messageOf([](PredictedLandmark& p) { p.H_y(1, 0) += 9.0; }).rfind(id + "H_y", 0), 0U);
    EXPECT_EQ(messageOf([](PredictedLandmark& p) { p.S(1, 1) *= 1.01; }).rfind(id + "S", 0), 0U);
    frame.landmarks[3].predicted.reset();
    EXPECT_THROW(frame.check(), std::invalid_argument);
}

TEST(RecordedFrameFile, HasNoWordForNumbersThatAreNotFinite)
{
    RecordedFrame frame = exampleFrame();
    frame.landmarks[0].candidates[0].z(0) = std::nan("");
    EXPECT_THROW(static_cast<void>(toText(frame)), std::invalid_argument);
}

TEST(RecordedFrameFile, IsReadFromADisk)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "one.json") << toText(exampleFrame());
    EXPECT_EQ(readRecordedFrame(folder / "one.json").index, 17);
    EXPECT_THROW(static_cast<void>(readRecordedFrame(folder / "none.json")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(readRecordedFrame(folder.path())), std::runtime_error);
}
}  // namespace monoslam::test
