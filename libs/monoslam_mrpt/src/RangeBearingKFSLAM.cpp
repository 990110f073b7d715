// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RangeBearingKFSLAM.h"

#include <algorithm>

#include "CompatiblePairs.h"
#include "copyIni.h"
#include "isInView.h"

namespace monoslam
{
using mrpt::obs::CObservationBearingRange;

namespace
{
bool isMrpts(DataAssociationMethod method)
{
    return method == assocNN_MRPT || method == assocJCBB_MRPT;
}

mrpt::slam::TDataAssociationMethod mrptMethod(DataAssociationMethod method)
{
    return method == assocJCBB_MRPT ? mrpt::slam::assocJCBB : mrpt::slam::assocNN;
}

/** An ini whose data_assoc_method MRPT understands. */
mrpt::config::CConfigFileMemory withMrptMethod(const mrpt::config::CConfigFileBase& ini)
{
    auto copy = copyOf(ini);
    copy.write("RangeBearingKFSLAM", "data_assoc_method", "assocNN");
    return copy;
}

}  // namespace

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::loadOptions(const mrpt::config::CConfigFileBase& ini)
{
    association = JointAssociationOptions::from(ini);
    if (association.method)
        MrptSlam::loadOptions(withMrptMethod(ini));
    else
        MrptSlam::loadOptions(ini);
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::reset()
{
    MrptSlam::reset();
    this->m_last_data_association = {};
    counters_ = before_ = {};
    presence_ = {};
}

template <class MrptSlam>
DataAssociationMethod JointKFSLAM<MrptSlam>::method() const
{
    return association.method.value_or(
        static_cast<DataAssociationMethod>(this->options.data_assoc_method));
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::copyStateFrom(const JointKFSLAM& other)
{
    this->m_xkk = other.m_xkk;
    this->m_pkk = other.m_pkk;
    this->m_IDs = other.m_IDs;
    this->m_SFs = other.m_SFs;
    this->m_last_data_association = other.m_last_data_association;
    counters_ = before_ = other.counters_;
    presence_ = other.presence_;
}

template <class MrptSlam>
AssignmentResult JointKFSLAM<MrptSlam>::choose(const AssignmentProblem& problem, long /*inView*/)
{
    return assign(problem, method(), association.node_cap);
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::OnGetObservationsAndDataAssociation(
    vector_KFArray_OBS& z, std::vector<int>& pairing, const vector_KFArray_OBS& predictions,
    const KFMatrix& S, const std::vector<std::size_t>& landmarks, const KFMatrix_OxO& R)
{
    // MRPT's own hook reads the observation; its association is kept only if it is asked for.
    const auto theirs = this->options.data_assoc_method;
    this->options.data_assoc_method = mrptMethod(method());
    MrptSlam::OnGetObservationsAndDataAssociation(z, pairing, predictions, S, landmarks, R);
    this->options.data_assoc_method = theirs;

    const auto sensor = this->m_SF->template getObservationByClass<CObservationBearingRange>();
    rows_.clear();
    std::vector<std::size_t> anonymous;
    for (std::size_t row = 0; row < z.size(); ++row)
    {
        rows_.push_back(row);
        if (sensor->sensedData[row].landmarkID < 0) anonymous.push_back(row);
    }
    inView_.clear();
    for (const KFArray_OBS& h : predictions) inView_.push_back(isInView(*sensor, h));
    if (!isMrpts(method()) && !anonymous.empty() && !landmarks.empty())
    {
        associate(anonymous, z, predictions, S, pairing);
        if (!association.insert_rejected) dropRejected(anonymous, z, pairing);
    }
    seen_.clear();
    for (const int landmark : pairing)
        if (landmark >= 0) seen_.insert(static_cast<std::size_t>(landmark));
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::associate(const std::vector<std::size_t>& rows,
                                      const vector_KFArray_OBS& z,
                                      const vector_KFArray_OBS& predictions, const KFMatrix& S,
                                      std::vector<int>& pairing)
{
    auto& last = this->m_last_data_association;
    for (const std::size_t row : rows) pairing[row] = -1;
    const std::set<int> taken(pairing.begin(), pairing.end());
    const auto& tests = this->options;
    const auto innovation = [&](std::size_t j, std::size_t i) -> Eigen::VectorXd
    {
        KFArray_OBS nu = z[rows[j]];
        this->OnSubstractObservationVectors(nu, predictions[last.predictions_IDs[i]]);
        return nu.asEigen();
    };
    CompatiblePairs pairs(rows.size(), S.asEigen(), innovation,
                          static_cast<Eigen::Index>(MrptSlam::get_observation_size()),
                          {tests.data_assoc_metric, tests.data_assoc_IC_chi2_thres,
                           tests.data_assoc_IC_metric, tests.data_assoc_IC_ml_threshold,
                           association.joint_chi2_thres > 0.0 ? association.joint_chi2_thres
                                                              : tests.data_assoc_IC_chi2_thres});
    pairs.exclude([&](std::size_t i)
                  { return taken.count(static_cast<int>(last.predictions_IDs[i])) > 0; });
    const AssignmentResult chosen =
        choose(pairs.problem(), std::count(inView_.begin(), inView_.end(), true));
    last.results = pairs.resultsOf(chosen);
    std::map<std::size_t, std::size_t> byRow;
    for (const auto& [j, i] : last.results.associations) byRow[rows[j]] = last.predictions_IDs[i];
    for (const auto& [row, landmark] : byRow) pairing[row] = static_cast<int>(landmark);
    last.results.associations = std::move(byRow);

    counters_ = before_;
    counters_.observations += static_cast<long>(rows.size());
    counters_.assigned += chosen.pairs;
    counters_.nodes += chosen.nodes;
    counters_.unproved += chosen.proved ? 0 : 1;
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::dropRejected(const std::vector<std::size_t>& rows,
                                         vector_KFArray_OBS& z, std::vector<int>& pairing)
{
    const auto& counts = this->m_last_data_association.results.indiv_compatibility_counts;
    std::set<std::size_t> rejected;
    for (std::size_t j = 0; j < rows.size(); ++j)
        if (pairing[rows[j]] < 0 && counts[j] > 0) rejected.insert(rows[j]);
    counters_.ignored += static_cast<long>(rejected.size());
    vector_KFArray_OBS keptZ;
    std::vector<int> keptAssociation;
    rows_.clear();
    for (std::size_t row = 0; row < z.size(); ++row)
    {
        if (rejected.count(row) > 0) continue;
        keptZ.push_back(z[row]);
        keptAssociation.push_back(pairing[row]);
        rows_.push_back(row);
    }
    z = std::move(keptZ);
    pairing = std::move(keptAssociation);
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::OnNewLandmarkAddedToMap(std::size_t observation, std::size_t landmark)
{
    MrptSlam::OnNewLandmarkAddedToMap(rows_[observation], landmark);
    this->m_last_data_association.newly_inserted_landmarks[rows_[observation]] = landmark;
    presence_.born();
}

template <class MrptSlam>
void JointKFSLAM<MrptSlam>::OnPostIteration()
{
    MrptSlam::OnPostIteration();
    auto&& P = this->m_pkk.asEigen();
    P = (0.5 * (P + P.transpose())).eval();
    before_ = counters_;
    for (std::size_t i = 0; i < inView_.size(); ++i)
        if (seen_.count(i) > 0)
            presence_.seen(i, association.p_detection);
        else if (inView_[i] || presence_.isNewborn(i))  // what is seen once may be nothing
            presence_.missed(i, association.p_detection);
    if (association.remove_missed.value_or(!isMrpts(method()))) removeAbsent();
}

template class JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM>;
template class JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM2D>;
}  // namespace monoslam
