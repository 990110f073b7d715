// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/dataAssociationFullCovariance.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/math/distributions.h>

#include "assignmentProblems.h"

#define ASSOCIATION_NAMESPACE mrpt::slam
#define FULL_COVARIANCE data_association_full_covariance
#define FULL_COVARIANCE_CALLER mrpt_caller
#include "fullCovarianceCaller.h"
#undef ASSOCIATION_NAMESPACE
#undef FULL_COVARIANCE
#undef FULL_COVARIANCE_CALLER
#define ASSOCIATION_NAMESPACE monoslam
#define FULL_COVARIANCE dataAssociationFullCovariance
#define FULL_COVARIANCE_CALLER our_caller
#include "fullCovarianceCaller.h"

namespace monoslam::test
{
namespace
{
using mrpt::math::CMatrixDouble;
using mrpt::slam::TDataAssociationResults;

struct Matrices
{
    CMatrixDouble Z, Y, S;
};

/** Predictions with a common error; observations of some of them, the wrong ones displaced. */
Matrices randomMatrices(Eigen::Index O, Eigen::Index predictions, Eigen::Index observations,
                        double spread, std::mt19937& rng)
{
    const Eigen::Index n = O * predictions;
    const Eigen::MatrixXd J = 3.0 * gaussian(n, 3, rng);
    const Eigen::MatrixXd S = J * J.transpose() + Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd y = spread * gaussian(n, 1, rng);
    const Eigen::VectorXd z = y + Eigen::VectorXd(S.llt().matrixL() * gaussian(n, 1, rng));
    Matrices m{CMatrixDouble(observations, O), CMatrixDouble(predictions, O), CMatrixDouble(n, n)};
    for (Eigen::Index i = 0; i < predictions; ++i)
        m.Y.asEigen().row(i) = y.segment(O * i, O).transpose();
    for (Eigen::Index j = 0; j < observations; ++j)
        m.Z.asEigen().row(j) = z.segment(O * j, O).transpose();
    m.S.asEigen() = S;
    return m;
}

/** MRPT's quantiles are an approximation: no pair may lie between its limit and the exact one. */
bool isBetweenTheLimits(const Matrices& m, double quantile)
{
    const Eigen::Index O = m.Z.cols();
    const double exact = chi2Limit(O, quantile);
    const double theirs = mrpt::math::chi2inv(quantile, static_cast<unsigned>(O));
    TDataAssociationResults results;
    dataAssociationFullCovariance(m.Z, m.Y, m.S, results, assocNN);
    const auto d2 = results.indiv_distances.asEigen().array();
    return (d2 >= std::min(exact, theirs) && d2 <= std::max(exact, theirs)).any();
}

void expectSameIndividualTests(const TDataAssociationResults& a, const TDataAssociationResults& b)
{
    EXPECT_EQ(a.indiv_compatibility_counts, b.indiv_compatibility_counts);
    for (Eigen::Index i = 0; i < a.indiv_compatibility.rows(); ++i)
        for (Eigen::Index j = 0; j < a.indiv_compatibility.cols(); ++j)
        {
            const bool compatible = a.indiv_compatibility(i, j);
            EXPECT_EQ(b.indiv_compatibility(i, j), compatible);
            if (!compatible) continue;
            EXPECT_NEAR(a.indiv_distances(i, j), b.indiv_distances(i, j), 1e-9);
        }
}
}  // namespace

TEST(DataAssociationFullCovariance, TakesTheCallsOfMrpts)
{
    // Far apart, so that there is one answer, and MRPT finds it.
    std::mt19937 rng(1);
    long compared = 0;
    for (int run = 0; run < 20; ++run)
    {
        const Matrices m = randomMatrices(2, 6, 4, 1000.0, rng);
        if (isBetweenTheLimits(m, 0.9) || isBetweenTheLimits(m, 0.95)) continue;
        if (isBetweenTheLimits(m, 0.99)) continue;
        const auto theirs = mrpt_caller::callInEveryWay(m.Z, m.Y, m.S);
        const auto pairs = static_cast<Eigen::Index>(theirs[0].associations.size());
        if (theirs[0].distance > chi2Limit(2 * pairs, 0.99)) continue;  // theirs alone accepts it
        ++compared;
        const auto ours = our_caller::callInEveryWay(m.Z, m.Y, m.S);
        for (std::size_t k = 0; k < ours.size(); ++k)
        {
            SCOPED_TRACE(k);
            EXPECT_EQ(ours[k].associations, theirs[k].associations);
            expectSameIndividualTests(ours[k], theirs[k]);
        }
        EXPECT_NEAR(ours[0].distance, theirs[0].distance, 1e-9);
    }
    EXPECT_GT(compared, 10);
}

TEST(DataAssociationFullCovariance, ChoosesNearestNeighboursAsMrptDoes)
{
    std::mt19937 rng(2);
    long several = 0;
    for (int run = 0; run < 300; ++run)
    {
        const Matrices m = randomMatrices(1 + run % 3, 8, 5, 4.0, rng);
        if (isBetweenTheLimits(m, 0.99)) continue;
        for (const auto metric : {metricMaha, metricML})
        {
            TDataAssociationResults theirs, ours;
            mrpt::slam::data_association_full_covariance(m.Z, m.Y, m.S, theirs, mrpt::slam::assocNN,
                                                         metric, 0.99, false);
            dataAssociationFullCovariance(m.Z, m.Y, m.S, ours, assocNN, metric);
            EXPECT_EQ(ours.associations, theirs.associations);
            expectSameIndividualTests(ours, theirs);
            for (const auto count : ours.indiv_compatibility_counts) several += count > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(several, 500);
}

TEST(DataAssociationFullCovariance, AcceptsOnlyWhatIsJointlyCompatible)
{
    std::mt19937 rng(3);
    long rejected = 0;
    for (int run = 0; run < 200; ++run)
    {
        const Eigen::Index O = 2 + run % 2;
        const Matrices m = randomMatrices(O, 7, 6, 4.0, rng);
        TDataAssociationResults mrpts, jcbb, hohct;
        mrpt::slam::data_association_full_covariance(m.Z, m.Y, m.S, mrpts, mrpt::slam::assocJCBB,
                                                     metricMaha, 0.95, false);
        dataAssociationFullCovariance(m.Z, m.Y, m.S, jcbb, assocJCBB, metricMaha, 0.95);
        dataAssociationFullCovariance(m.Z, m.Y, m.S, hohct, assocHOHCT, metricMaha, 0.95);
        for (const auto* results : {&jcbb, &hohct})
            EXPECT_LE(results->distance,
                      chi2Limit(O * static_cast<Eigen::Index>(results->associations.size()), 0.95));
        EXPECT_GE(hohct.associations.size(), jcbb.associations.size());
        rejected += mrpts.associations.size() > hohct.associations.size() ? 1 : 0;
    }
    EXPECT_GT(rejected, 0);
}

TEST(DataAssociationFullCovariance, CallsMrptWhereItIsNamed)
{
    std::mt19937 rng(4);
    const Matrices m = randomMatrices(2, 6, 4, 4.0, rng);
    TDataAssociationResults theirs, ours;
    mrpt::slam::data_association_full_covariance(m.Z, m.Y, m.S, theirs);
    dataAssociationFullCovariance(m.Z, m.Y, m.S, ours, assocJCBB_MRPT);
    EXPECT_EQ(ours.associations, theirs.associations);
    EXPECT_EQ(ours.nNodesExploredInJCBB, theirs.nNodesExploredInJCBB);
}

TEST(DataAssociationFullCovariance, RefusesWhatCannotBeAssociated)
{
    std::mt19937 rng(5);
    const Matrices m = randomMatrices(2, 3, 2, 4.0, rng);
    TDataAssociationResults results;
    const auto call = [&](const Matrices& bad, double quantile = 0.99)
    { dataAssociationFullCovariance(bad.Z, bad.Y, bad.S, results, assocNN, metricMaha, quantile); };
    EXPECT_THROW(call({CMatrixDouble(0, 2), m.Y, m.S}), std::invalid_argument);
    EXPECT_THROW(call({m.Z, CMatrixDouble(0, 2), m.S}), std::invalid_argument);
    EXPECT_THROW(call({CMatrixDouble(2, 3), m.Y, m.S}), std::invalid_argument);
    EXPECT_THROW(call({m.Z, m.Y, CMatrixDouble(6, 5)}), std::invalid_argument);
    EXPECT_THROW(call(m, 1.0), std::invalid_argument);
    Matrices nan = m;
    nan.Z(0, 0) = std::nan("");
    EXPECT_THROW(call(nan), std::invalid_argument);
    EXPECT_THROW(dataAssociationFullCovariance(m.Z, m.Y, m.S, results, assocMHDA),
                 std::invalid_argument);
    EXPECT_THROW(dataAssociationFullCovariance(m.Z, m.Y, m.S, results, assocNN, metricMaha, 0.99,
                                               true, {1, 2}),
                 std::invalid_argument);
}

TEST(DataAssociationMethod, IsReadByMrptsIniReader)
{
    mrpt::config::CConfigFileMemory ini("[s]\na = HOHCT\nb = assocJCBB\nc = JCBB_MRPT\nd = 1\n");
    const auto read = [&](const char* key)
    { return ini.read_enum<DataAssociationMethod>("s", key, assocNN); };
    EXPECT_EQ(read("a"), assocHOHCT);
    EXPECT_EQ(read("b"), assocJCBB);
    EXPECT_EQ(read("c"), assocJCBB_MRPT);
    EXPECT_EQ(read("d"), assocJCBB);
    EXPECT_EQ(read("none"), assocNN);
    EXPECT_EQ(mrpt::typemeta::TEnumType<DataAssociationMethod>::value2name(assocMHDA), "MHDA");
}
}  // namespace monoslam::test
