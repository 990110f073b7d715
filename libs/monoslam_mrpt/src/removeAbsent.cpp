// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monoslam_mrpt/RangeBearingKFSLAM.h"

namespace monoslam
{
template <class MrptSlam>
void JointKFSLAM<MrptSlam>::removeAbsent()
{
    const std::vector<std::size_t> absent = presence_.absent();
    for (const auto& [index, id] : this->m_IDs.getInverseMap())
        if (static_cast<std::size_t>(id) != index) return;  // the sensor's own IDs are trusted
    if (absent.empty()) return;
    const std::size_t n = presence_.count();
    std::map<std::size_t, std::size_t> newIndex;
    std::vector<Eigen::Index> kept;
    for (std::size_t k = 0; k < MrptSlam::get_vehicle_size(); ++k)
        kept.push_back(static_cast<Eigen::Index>(k));
    for (std::size_t i = 0; i < n; ++i)
    {
        if (std::binary_search(absent.begin(), absent.end(), i)) continue;
        newIndex.emplace(i, newIndex.size());
        const std::size_t first = MrptSlam::get_vehicle_size() + i * MrptSlam::get_feature_size();
        for (std::size_t k = 0; k < MrptSlam::get_feature_size(); ++k)
            kept.push_back(static_cast<Eigen::Index>(first + k));
    }
    const Eigen::VectorXd x = this->m_xkk.asEigen()(kept);
    const Eigen::MatrixXd P = this->m_pkk.asEigen()(kept, kept);
    this->m_xkk.resize(kept.size());
    this->m_xkk.asEigen() = x;
    this->m_pkk.setSize(P.rows(), P.cols());
    this->m_pkk.asEigen() = P;
    presence_.erase(absent);
    renumber(newIndex);
    counters_.removed += static_cast<long>(absent.size());
    before_ = counters_;
}

/** MRPT's maps of indices, after a removal. */
template <class MrptSlam>
void JointKFSLAM<MrptSlam>::renumber(const std::map<std::size_t, std::size_t>& newIndex)
{
    this->m_IDs.clear();
    for (const auto& entry : newIndex)
        this->m_IDs.insert(static_cast<mrpt::maps::CLandmark::TLandmarkID>(entry.second),
                           static_cast<unsigned int>(entry.second));
    auto& last = this->m_last_data_association;
    for (auto* indices : {&last.results.associations, &last.newly_inserted_landmarks})
    {
        std::map<std::size_t, std::size_t> renumbered;
        for (const auto& [row, landmark] : *indices)
            if (const auto entry = newIndex.find(landmark); entry != newIndex.end())
                renumbered[row] = entry->second;
        *indices = std::move(renumbered);
    }
}

using Indices = std::map<std::size_t, std::size_t>;
template void JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM>::removeAbsent();
template void JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM2D>::removeAbsent();
template void JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM>::renumber(const Indices&);
template void JointKFSLAM<mrpt::slam::CRangeBearingKFSLAM2D>::renumber(const Indices&);
}  // namespace monoslam
