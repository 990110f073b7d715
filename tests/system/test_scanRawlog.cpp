// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <zlib.h>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "monoslam_mrpt/RawlogReader.h"

namespace monoslam
{
namespace
{
/** Bytes of a rawlog without its compression. */
std::string inflated(const std::string& file)
{
    mrpt::io::CFileGZInputStream stream(file);
    std::string bytes(1 << 20, '\0');
    bytes.resize(stream.Read(bytes.data(), bytes.size()));
    return bytes;
}

/** A rawlog cut to some length, or that there is nothing to be read before the cut. */
std::optional<RawlogContents> scanCut(const std::string& file, std::size_t length)
{
    std::filesystem::resize_file(file, length);
    try
    {
        return scanRawlog(file);
    }
    catch (const std::runtime_error&)
    {
        return std::nullopt;
    }
}
}  // namespace

TEST(ScanRawlog, NoticesWhereverAGzFileIsCut)
{
    TemporaryFolder folder;
    writeExampleRawlog(folder / "a.rawlog", exampleTimes(3));
    EXPECT_EQ(scanRawlog(folder / "a.rawlog").damage, "");
    for (auto length = std::filesystem::file_size(folder / "a.rawlog") - 1; length > 0; --length)
    {
        const auto contents = scanCut(folder / "a.rawlog", length);
        if (!contents) continue;
        EXPECT_NE(contents->damage.find("a.rawlog: truncated"), std::string::npos) << length;
    }
}

/** The compressed data end exactly after an object; only the trailer is missing. */
TEST(ScanRawlog, NoticesAGzFileThatEndsBetweenTwoObjects)
{
    TemporaryFolder folder;
    const std::string file = folder / "a.rawlog";
    writeExampleRawlog(file, exampleTimes(3), true);
    const std::string bytes = inflated(file);
    const gzFile gz = gzopen(file.c_str(), "wb");
    gzwrite(gz, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzflush(gz, Z_SYNC_FLUSH);
    std::filesystem::copy_file(file, folder / "cut.rawlog");
    gzclose(gz);
    EXPECT_EQ(scanRawlog(file).damage, "");
    const RawlogContents cut = scanRawlog(folder / "cut.rawlog");
    EXPECT_EQ(cut.imageTimes.at("camera").size(), 3U);
    EXPECT_NE(cut.damage.find("cut.rawlog: truncated or damaged after 6 objects"),
              std::string::npos)
        << cut.damage;
    RawlogOptions options;
    options.file = folder / "cut.rawlog";
    RawlogReader reader(options, {});
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(reader.next());
    EXPECT_THROW((void)reader.next(), std::runtime_error);
}

TEST(ScanRawlog, TakesAPlainFileForCompleteOnlyBetweenTwoObjects)
{
    TemporaryFolder folder;
    writeExampleRawlog(folder / "a.rawlog", exampleTimes(3));
    writeText(folder / "plain.rawlog", inflated(folder / "a.rawlog"));
    EXPECT_EQ(scanRawlog(folder / "plain.rawlog").damage, "");
    int complete = 0;
    for (auto length = std::filesystem::file_size(folder / "plain.rawlog") - 1; length > 0;
         --length)
    {
        const auto contents = scanCut(folder / "plain.rawlog", length);
        complete += contents && contents->damage.empty() ? 1 : 0;
    }
    EXPECT_EQ(complete, 5);  // of six objects the last, the last two, ...
}

TEST(ScanRawlog, NoticesAFlippedBit)
{
    TemporaryFolder folder;
    writeExampleRawlog(folder / "a.rawlog", exampleTimes(3), true);
    std::string bytes = readText(folder / "a.rawlog");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    writeText(folder / "a.rawlog", bytes);
    const auto contents = scanCut(folder / "a.rawlog", bytes.size());
    if (contents)
    {
        EXPECT_NE(contents->damage, "");
    }
}
}  // namespace monoslam
