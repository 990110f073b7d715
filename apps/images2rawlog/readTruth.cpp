// SPDX-License-Identifier: BSD-3-Clause
#include "readTruth.h"

#include <mrpt/poses/CPose3DQuat.h>

#include <algorithm>
#include <stdexcept>

#include "TextTable.h"

namespace monoslam
{
using mrpt::poses::CPose3D;

namespace
{
struct QuaternionColumns
{
    std::size_t w, x, y, z;
};

CPose3D poseOf(const TableRow& row, QuaternionColumns q)
{
    mrpt::math::CQuaternionDouble rotation(row.number(q.w), row.number(q.x), row.number(q.y),
                                           row.number(q.z));
    if (rotation.normSqr() < 0.25) row.fail("the quaternion is not of unit length");
    rotation.normalize();
    return CPose3D(rotation, row.number(1), row.number(2), row.number(3));
}

RecordedPose tumPose(const TableRow& row)
{
    const auto t = parseSeconds(row.words[0]);
    if (!t) row.fail("not a time: " + row.words[0]);
    return {*t, poseOf(row, {7, 4, 5, 6})};
}

RecordedPose eurocPose(const TableRow& row, const CPose3D& cameraPose)
{
    const auto t = parseNanoseconds(row.words[0]);
    if (!t) row.fail("not a time: " + row.words[0]);
    return {*t, poseOf(row, {4, 5, 6, 7}) + cameraPose};
}

CPose3D kittiPose(const TableRow& row)
{
    mrpt::math::CMatrixDouble44 T;
    T.setIdentity();
    for (std::size_t i = 0; i < 12; ++i)
        T(static_cast<int>(i / 4), static_cast<int>(i % 4)) = row.number(i);
    return CPose3D(T);
}
}  // namespace

std::vector<RecordedPose> readTruth(const std::string& file, const CPose3D& cameraPose,
                                    const std::vector<Ticks>& imageTimes)
{
    std::vector<RecordedPose> poses;
    for (const auto& row : readTable(file))
    {
        const bool isKitti = !row.commas && row.words.size() == 12;
        if (isKitti && poses.size() == imageTimes.size()) row.fail("more poses than images");
        if (isKitti)
            poses.push_back({imageTimes[poses.size()], kittiPose(row)});
        else
            poses.push_back(row.commas ? eurocPose(row, cameraPose) : tumPose(row));
    }
    if (poses.empty()) throw std::runtime_error(file + ": there are no poses in it");
    std::stable_sort(poses.begin(), poses.end(),
                     [](const RecordedPose& a, const RecordedPose& b) { return a.t < b.t; });
    return poses;
}
}  // namespace monoslam
