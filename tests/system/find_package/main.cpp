// SPDX-License-Identifier: BSD-3-Clause
#include <monoslam_association/Associator.h>
#include <monoslam_models/quaternion.h>
#include <monoslam_mrpt/RawlogReader.h>
#include <monoslam_slam/MonoSlam.h>

#include <algorithm>
#include <iostream>

int main()
{
    const Eigen::Vector3d quarterTurn(0.0, 0.0, 1.5707963267948966);
    const Eigen::Vector4d q = monoslam::quaternionExp(quarterTurn);
    const Eigen::Vector3d rotated = monoslam::rotate(q, Eigen::Vector3d::UnitX());
    std::cout << "x axis turned by 90 degrees about z: " << rotated.transpose() << '\n';

    const auto names = monoslam::associatorNames();
    for (const std::string& name : names) std::cout << "association strategy " << name << '\n';

    const bool known = std::find(names.begin(), names.end(), "hohct") != names.end();
    return known && rotated.isApprox(Eigen::Vector3d::UnitY()) ? 0 : 1;
}
