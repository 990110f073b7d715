// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <stdexcept>

#include "jacobianMatches.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/quaternion.h"
#include "monoslam_support/ConfigSection.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
using namespace camera_state;
using mrpt::config::CConfigFileMemory;

Vector13d randomState(std::mt19937& rng, double rate)
{
    Vector13d x_v;
    x_v << uniformVector<3>(rng, 2.0), randomQuaternion(rng), uniformVector<3>(rng, 3.0),
        uniformVector<3>(rng, rate);
    return x_v;
}

ConstantVelocityOptions optionsOf(const std::string& lines)
{
    const CConfigFileMemory file("[motion]\n" + lines + "\n");
    return ConstantVelocityOptions::from(ConfigSection(file, "motion"));
}

/** Velocity and angular velocity variance gathered in one second. */
Eigen::Vector2d varianceAfterOneSecond(NoiseForm noise, int steps)
{
    const ConstantVelocityOptions options{noise, 1.5, 0.7};
    const MotionPrediction step =
        predictConstantVelocity(Vector13d::Unit(kOrientation), 1.0 / steps, options);
    return steps * Eigen::Vector2d(step.Q(kVelocity, kVelocity),
                                   step.Q(kAngularVelocity, kAngularVelocity));
}
}  // namespace

TEST(ConstantVelocity, JacobianMatchesDifferencesAtAllRatesAndSteps)
{
    std::mt19937 rng(1);
    for (const double rate : {0.0, 1e-9, 1e-2, 5.0})
        for (const double dt_s : {0.0, 1.0 / 30, 0.5})
            for (int i = 0; i < 10; ++i)
            {
                const Vector13d x_v = randomState(rng, rate);
                const auto f = [&](const Vector13d& x)
                { return predictConstantVelocity(x, dt_s, {}).x_v; };
                EXPECT_TRUE(jacobianMatches(f, x_v, predictConstantVelocity(x_v, dt_s, {}).F, 1e-8))
                    << "rate " << rate << ", dt " << dt_s;
            }
}

TEST(ConstantVelocity, NoiseEntersAsAnImpulseOnTheVelocities)
{
    // r, q see v + V and omega + Omega, so df/d(V, Omega) is df/d(v, omega)
    std::mt19937 rng(2);
    for (int i = 0; i < 100; ++i)
    {
        const Vector13d x_v = randomState(rng, 2.0);
        const ConstantVelocityOptions options{NoiseForm::PerFrame, 3.0, 5.0};
        const MotionPrediction p = predictConstantVelocity(x_v, 0.1, options);
        Eigen::Matrix<double, 6, 1> sigma;
        sigma << 0.3, 0.3, 0.3, 0.5, 0.5, 0.5;
        const Eigen::Matrix<double, 13, 6> root = p.F.rightCols<6>() * sigma.asDiagonal();
        EXPECT_LT((p.Q - root * root.transpose()).norm(), 1e-14);
        EXPECT_EQ(p.Q, p.Q.transpose());
    }
}

TEST(ConstantVelocity, SampledImpulsesHaveTheVarianceOfQ)
{
    std::mt19937 rng(3);
    const Vector13d x_v = randomState(rng, 1.0);
    const ConstantVelocityOptions options{NoiseForm::Density, 0.5, 0.4};
    const double dt_s = 0.04;
    const MotionPrediction p = predictConstantVelocity(x_v, dt_s, options);
    constexpr int kSamples = 20000;
    Matrix13d sampled = Matrix13d::Zero();
    for (int i = 0; i < kSamples; ++i)
    {
        Vector13d pushed = x_v;
        pushed.segment<3>(kVelocity) += normalVector<3>(rng, 0.5 * std::sqrt(dt_s));
        pushed.segment<3>(kAngularVelocity) += normalVector<3>(rng, 0.4 * std::sqrt(dt_s));
        const Vector13d error = predictConstantVelocity(pushed, dt_s, options).x_v - p.x_v;
        sampled += error * error.transpose() / kSamples;
    }
    for (const Eigen::Index k : {kPosition, kOrientation + 1, kVelocity, kAngularVelocity})
        EXPECT_NEAR(sampled(k, k) / p.Q(k, k), 1.0, 0.05) << k;
}

TEST(ConstantVelocity, DensityGivesTheSameVarianceAtEveryFrameRate)
{
    const Eigen::Vector2d slow = varianceAfterOneSecond(NoiseForm::Density, 10);
    const Eigen::Vector2d fast = varianceAfterOneSecond(NoiseForm::Density, 100);
    EXPECT_LT((slow - Eigen::Vector2d(1.5 * 1.5, 0.7 * 0.7)).norm(), 1e-12);
    EXPECT_LT((slow - fast).norm(), 1e-12);
}

TEST(ConstantVelocity, PerFrameNoiseShrinksWithTheFrameRate)
{
    const Eigen::Vector2d slow = varianceAfterOneSecond(NoiseForm::PerFrame, 10);
    const Eigen::Vector2d fast = varianceAfterOneSecond(NoiseForm::PerFrame, 100);
    EXPECT_LT((slow - 10 * fast).norm(), 1e-12);
}

TEST(ConstantVelocity, ManyShortStepsEqualOneLongStep)
{
    std::mt19937 rng(4);
    const Vector13d x_v = randomState(rng, 2.0);
    Vector13d stepped = x_v;
    for (int i = 0; i < 50; ++i) stepped = predictConstantVelocity(stepped, 0.02, {}).x_v;
    EXPECT_LT((stepped - predictConstantVelocity(x_v, 1.0, {}).x_v).norm(), 1e-12);
}

TEST(ConstantVelocity, TurnsAboutTheAxisOfTheCamera)
{
    // camera looking along world x; a turn about its own z must keep z where it is
    Vector13d x_v = Vector13d::Zero();
    x_v.segment<4>(kOrientation) = quaternionExp(Eigen::Vector3d(0, 1.57, 0));
    x_v.segment<3>(kAngularVelocity) = Eigen::Vector3d(0, 0, 1);
    const Eigen::Vector3d before = rotate(x_v.segment<4>(kOrientation), Eigen::Vector3d::UnitZ());
    const Vector13d after = predictConstantVelocity(x_v, 0.5, {}).x_v;
    const Eigen::Vector3d axis = rotate(after.segment<4>(kOrientation), Eigen::Vector3d::UnitZ());
    EXPECT_LT((axis - before).norm(), 1e-14);
}

TEST(ConstantVelocity, RefusesToGoBackInTime)
{
    const Vector13d x_v = Vector13d::Unit(kOrientation);
    EXPECT_THROW((void)predictConstantVelocity(x_v, -0.01, {}), std::invalid_argument);
    EXPECT_THROW((void)predictConstantVelocity(x_v, std::nan(""), {}), std::invalid_argument);
}

TEST(ConstantVelocity, ReadsItsOptions)
{
    const ConstantVelocityOptions o =
        optionsOf("noise = per_frame\nsigma_accel_mps2 = 4\nsigma_alpha_radps2 = 6");
    EXPECT_EQ(o.noise, NoiseForm::PerFrame);
    EXPECT_EQ(o.sigma_accel, 4.0);
    EXPECT_EQ(o.sigma_alpha, 6.0);
    EXPECT_EQ(optionsOf("").noise, NoiseForm::Density);
}

TEST(ConstantVelocity, RefusesBadOptions)
{
    for (const char* lines : {"sigma_accel_mps2 = 0", "sigma_alpha_radps2 = -1", "noise = white",
                              "sigma_accel = 1", "sigma_alpha_radps2 = fast"})
        EXPECT_THROW((void)optionsOf(lines), std::invalid_argument) << lines;
}
}  // namespace monoslam
