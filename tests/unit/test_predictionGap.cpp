// SPDX-License-Identifier: BSD-3-Clause
#include "predictionGap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace monoslam
{
TEST(PredictionGap, IsWhatThePredictionAdds)
{
    using Matrix6d = Eigen::Matrix<double, 6, 6>;
    Matrix6d before = 0.3 * Matrix6d::Identity();
    Matrix6d after = before;
    EXPECT_EQ(lineOfSightGrowth_rad(before, after, 2.0), 0.0);
    after.diagonal() << 0.01, 0.01, 0.01, 0.0, 0.0, 0.0;
    after += before;
    const double gate = std::sqrt(-2.0 * std::log(0.05));  // of chi2(2) at 95 %
    EXPECT_NEAR(lineOfSightGrowth_rad(before, after, 2.0), gate * 2.0 * 0.1, 1e-9);
    after.diagonal().tail<3>().array() += 0.04;
    EXPECT_NEAR(lineOfSightGrowth_rad(before, after, 0.0), gate * 0.2, 1e-9);
    EXPECT_NEAR(lineOfSightGrowth_rad(before, after, 2.0), gate * std::sqrt(0.08), 1e-9);
    EXPECT_EQ(lineOfSightGrowth_rad(after, before, 2.0), 0.0);
}
}  // namespace monoslam
