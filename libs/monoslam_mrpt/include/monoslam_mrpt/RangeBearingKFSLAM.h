// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/slam/CRangeBearingKFSLAM.h>
#include <mrpt/slam/CRangeBearingKFSLAM2D.h>

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_mrpt/DataAssociationMethod.h"
#include "monoslam_mrpt/LandmarkPresence.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** What MRPT's options of data association lack. */
struct MONOSLAM_MRPT_EXPORT JointAssociationOptions
{
    /** [RangeBearingKFSLAM] data_assoc_method; if empty, that of MRPT's options. */
    std::optional<DataAssociationMethod> method;
    /** Of right assignments that pass the joint test; 0 = data_assoc_IC_chi2_thres. */
    double joint_chi2_thres = 0.0;
    int node_cap = 20000;  ///< of JCBB and HOHCT; then the best assignment so far is taken
    /** What becomes of an observation that is compatible with a landmark and was not assigned: a
     *  new landmark, as in MRPT, or nothing. */
    bool insert_rejected = false;
    /** Landmarks that are missed in the sensor's field of view, and those that are not seen in the step
     *  after their first, wherever that is, are taken out of the map, unless they bear IDs; MRPT has
     *  nothing like it. If empty: yes, but with MRPT's own association. */
    std::optional<bool> remove_missed;
    double p_detection = 0.9;  ///< of a landmark in view

    /** Reads data_assoc_method and [RangeBearingKFSLAM_Joint].
     *  \throw std::invalid_argument naming section and key */
    static JointAssociationOptions from(const mrpt::config::CConfigFileBase& ini);
};

/** What the data association of a run did. */
struct JointAssociationCounters
{
    long observations = 0;  ///< without an ID, while there were predictions
    long assigned = 0;
    long ignored = 0;  ///< rejected and not inserted
    long removed = 0;  ///< landmarks that were missed
    long nodes = 0;
    long unproved = 0;  ///< steps in which the node cap ended the search
};

/** MRPT's EKF-SLAM with our data association; everything else is inherited.
 *
 * Differs from MRPT's class further in that angles are wrapped in innovations, that an observation
 * without an ID never takes the landmark of one that has one, that
 * getLastDataAssociation() names the landmarks that were inserted, and in a covariance that stays
 * symmetric. */
template <class MrptSlam>
class JointKFSLAM : public MrptSlam
{
   public:
    /** [RangeBearingKFSLAM] and [RangeBearingKFSLAM_KalmanFilter] as MRPT's, with more names for
     *  data_assoc_method; [RangeBearingKFSLAM_Joint] is ours. */
    void loadOptions(const mrpt::config::CConfigFileBase& ini);

    /** Empties the map and forgets the last association; options stay. */
    void reset();

    JointAssociationOptions association;

    [[nodiscard]] DataAssociationMethod method() const;
    [[nodiscard]] const JointAssociationCounters& counters() const { return counters_; }
    /** Numbers of the landmarks that do not change when others are removed from the map. */
    [[nodiscard]] const LandmarkPresence& presence() const { return presence_; }

    /** Belief, map and last association of another filter; options stay. */
    void copyStateFrom(const JointKFSLAM& other);

   protected:
    using typename MrptSlam::KFArray_OBS;
    using typename MrptSlam::KFMatrix;
    using typename MrptSlam::KFMatrix_OxO;
    using typename MrptSlam::vector_KFArray_OBS;

    void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& z, std::vector<int>& pairing,
                                             const vector_KFArray_OBS& predictions,
                                             const KFMatrix& S,
                                             const std::vector<std::size_t>& landmarks,
                                             const KFMatrix_OxO& R) override;
    void OnNewLandmarkAddedToMap(std::size_t observation, std::size_t landmark) override;
    void OnPostIteration() override;

    /** By method(), unless a filter that draws its associations says otherwise. May be called twice
     *  in an iteration: the last answer counts.
     *  \param inView  landmarks whose predictions are within the sensor's range and field of view */
    [[nodiscard]] virtual AssignmentResult choose(const AssignmentProblem& problem, long inView);

   private:
    void associate(const std::vector<std::size_t>& rows, const vector_KFArray_OBS& z,
                   const vector_KFArray_OBS& predictions, const KFMatrix& S,
                   std::vector<int>& pairing);
    void dropRejected(const std::vector<std::size_t>& rows, vector_KFArray_OBS& z,
                      std::vector<int>& pairing);
    void removeAbsent();
    void renumber(const std::map<std::size_t, std::size_t>& newIndex);

    JointAssociationCounters counters_, before_;
    LandmarkPresence presence_;
    std::vector<std::size_t> rows_;  ///< in the observation, of those that the filter was given
    std::vector<bool> inView_;       ///< of the landmarks of the map before this step
    std::set<std::size_t> seen_;     ///< those that were associated
};

/** Poses and landmarks in space, mrpt::slam::CRangeBearingKFSLAM. */
using RangeBearingKFSLAM = JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM>;
/** Poses and landmarks in the plane, mrpt::slam::CRangeBearingKFSLAM2D. */
using RangeBearingKFSLAM2D = JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM2D>;

extern template class MONOSLAM_MRPT_EXPORT JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM>;
extern template class MONOSLAM_MRPT_EXPORT JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM2D>;
}  // namespace monoslam
