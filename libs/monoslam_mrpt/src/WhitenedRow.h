// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>

#include "monoslam_models/InverseDepth.h"

namespace monoslam
{
/** What MRPT sees of one landmark: everything is divided by L, R = L L', so that noise is I. */
struct WhitenedRow
{
    bool observed = false;
    Eigen::Vector2d z = Eigen::Vector2d::Zero();
    Eigen::Vector2d h = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, 2, 13> H_v = Eigen::Matrix<double, 2, 13>::Zero();
    Eigen::Matrix<double, 2, 6> H_y = Eigen::Matrix<double, 2, 6>::Zero();
    Eigen::Matrix2d L = Eigen::Matrix2d::Identity();

    void measure(const Eigen::Vector2d& z_px, const Eigen::Matrix2d& R_px2)
    {
        observed = true;
        L = R_px2.llt().matrixL();
        z = L.triangularView<Eigen::Lower>().solve(z_px);
    }
    void predict(const Eigen::Vector2d& h_px, const Eigen::Matrix<double, 2, 13>& J_h_xv,
                 const Eigen::Matrix<double, 2, 6>& J_h_y)
    {
        h = L.triangularView<Eigen::Lower>().solve(h_px);
        H_v = L.triangularView<Eigen::Lower>().solve(J_h_xv);
        H_y = L.triangularView<Eigen::Lower>().solve(J_h_y);
    }
};
}  // namespace monoslam
