// SPDX-License-Identifier: BSD-3-Clause
#include "Filter.h"

#include <mrpt/poses/CPose3DQuatPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include "monoslam_mrpt/RangeBearingMhda.h"

namespace monoslam
{
namespace
{
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

/** One filter, in the manner of RangeBearingMhda. */
template <class Slam>
class SingleFilter
{
   public:
    void loadOptions(const mrpt::config::CConfigFileBase& ini) { slam_.loadOptions(ini); }
    void processActionObservation(mrpt::obs::CActionCollection::Ptr& action,
                                  mrpt::obs::CSensoryFrame::Ptr& observations)
    {
        slam_.processActionObservation(action, observations);
    }
    [[nodiscard]] const Slam& best() const { return slam_; }

   private:
    Slam slam_;
};

template <class Slam>
struct PosePdf;
template <>
struct PosePdf<RangeBearingKFSLAM>
{
    using Type = mrpt::poses::CPose3DQuatPDFGaussian;
};
template <>
struct PosePdf<RangeBearingKFSLAM2D>
{
    using Type = mrpt::poses::CPosePDFGaussian;
};

template <class Slam, class Carrier>
class FilterOf : public Filter
{
   public:
    template <class... Arguments>
    explicit FilterOf(const mrpt::config::CConfigFileBase& ini, Arguments... arguments)
        : carrier_(arguments...)
    {
        carrier_.loadOptions(ini);
    }

    void process(mrpt::obs::CActionCollection::Ptr& action,
                 mrpt::obs::CSensoryFrame::Ptr& observations) override
    {
        carrier_.processActionObservation(action, observations);
        best().getCurrentState(pose_, points_, ids_, x_, P_);
    }

    [[nodiscard]] CPose3D pose() const override { return CPose3D(pose_.mean); }
    [[nodiscard]] mrpt::math::CVectorDouble poseVector() const override
    {
        const auto p = pose_.mean.asVectorVal();
        mrpt::math::CVectorDouble numbers(static_cast<std::size_t>(p.size()));
        for (int i = 0; i < numbers.size(); ++i) numbers[i] = p[i];
        return numbers;
    }
    [[nodiscard]] mrpt::math::CMatrixDouble covariance() const override { return P_; }
    [[nodiscard]] std::vector<MappedLandmark> landmarks() const override
    {
        std::vector<MappedLandmark> all;
        for (std::size_t i = 0; i < points_.size(); ++i)
            all.push_back(
                {TPoint3D(points_[i]), static_cast<long>(ids_.at(static_cast<unsigned int>(i)))});
        return all;
    }
    [[nodiscard]] std::map<std::size_t, std::size_t> associations() const override
    {
        return serials(best().getLastDataAssociation().results.associations);
    }
    [[nodiscard]] std::map<std::size_t, std::size_t> inserted() const override
    {
        return serials(best().getLastDataAssociation().newly_inserted_landmarks);
    }
    [[nodiscard]] JointAssociationCounters counters() const override { return best().counters(); }
    void drawInto(mrpt::opengl::CSetOfObjects::Ptr& objects) const override
    {
        best().getAs3DObject(objects);
    }
    void saveAsMatlab(const std::string& file) const override
    {
        best().saveMapAndPath2DRepresentationAsMATLABFile(file);
    }

   private:
    [[nodiscard]] const Slam& best() const { return carrier_.best(); }
    [[nodiscard]] std::map<std::size_t, std::size_t> serials(
        std::map<std::size_t, std::size_t> landmarks) const
    {
        for (auto& entry : landmarks) entry.second = best().presence().serial(entry.second);
        return landmarks;
    }

    Carrier carrier_;
    typename PosePdf<Slam>::Type pose_;
    std::vector<typename Slam::landmark_point_t> points_;
    std::map<unsigned int, mrpt::maps::CLandmark::TLandmarkID> ids_;
    mrpt::math::CVectorDouble x_;
    mrpt::math::CMatrixDouble P_;
};

template <class Slam>
std::unique_ptr<Filter> makeFilterOf(const Config& config)
{
    const auto method = JointAssociationOptions::from(config.ini).method;
    if (method == assocMHDA)
        return std::make_unique<FilterOf<Slam, RangeBearingMhda<Slam>>>(config.ini, config.seed);
    return std::make_unique<FilterOf<Slam, SingleFilter<Slam>>>(config.ini);
}
}  // namespace

std::unique_ptr<Filter> makeFilter(const Config& config)
{
    return config.inPlane ? makeFilterOf<RangeBearingKFSLAM2D>(config)
                          : makeFilterOf<RangeBearingKFSLAM>(config);
}
}  // namespace monoslam
