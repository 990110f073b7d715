// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/MonocularKFSLAM.h"

#include <stdexcept>

#include "copyIni.h"
#include "monoslam_association/Associator.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_mrpt/makeEngine.h"
#include "monoslam_mrpt/scene3d.h"
#include "monoslam_mrpt/timestamps.h"
#include "monoslam_slam/writers.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
using mrpt::config::CConfigFileBase;
using mrpt::config::CConfigFileMemory;
using mrpt::maps::CLandmark;
using mrpt::math::CMatrixDouble;
using mrpt::math::CVectorDouble;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3DPDFGaussian;
using mrpt::poses::CPose3DQuatPDFGaussian;

/** What loadOptions() read; the file is kept, because a strategy is made anew for each map. */
struct MonocularKFSLAM::Options
{
    MonoSlamOptions slam;
    CameraOptions camera;
    CConfigFileMemory ini;
    std::string fileName;

    [[nodiscard]] std::unique_ptr<Associator> associator() const
    {
        ConfigSection section(ini, "association", fileName);
        return makeAssociator(section.get("strategy", "hohct"), ini, fileName);
    }
};

MonocularKFSLAM::MonocularKFSLAM(unsigned seed) : seed_(seed)
{
    loadOptions(CConfigFileMemory(""));
}

MonocularKFSLAM::~MonocularKFSLAM() = default;

void MonocularKFSLAM::loadOptions(const CConfigFileBase& ini, const std::string& fileName)
{
    auto options = std::make_unique<Options>();
    options->slam = MonoSlamOptions::from(ini, fileName);
    options->camera = CameraOptions::from(ConfigSection(ini, "camera", fileName));
    options->ini = copyOf(ini);
    options->fileName = fileName;
    static_cast<void>(options->associator());
    options_ = std::move(options);
    reset();
}

void MonocularKFSLAM::reset()
{
    slam_.reset();
    path_.clear();
    frames_ = 0;
    hasPose_ = false;
}

void MonocularKFSLAM::begin(const RecordedImage& recorded)
{
    if (!options_->camera.calibration && !isCalibrated(*recorded.camera))
        throw std::invalid_argument(
            "MonocularKFSLAM: the image has no calibration; set [camera] source = ini");
    slam_ = std::make_unique<MonoSlam>(
        options_->slam, Camera(options_->camera.choose(*recorded.camera)), options_->associator(),
        seed_, makeEngine(options_->slam.engine));
}

std::optional<FrameReport> MonocularKFSLAM::processObservation(
    const mrpt::obs::CObservation::Ptr& observation)
{
    if (!observation) throw std::invalid_argument("MonocularKFSLAM: no observation");
    const auto recorded = imageOf(*observation, StereoSide::Left);
    if (!recorded) return std::nullopt;
    if (!slam_) begin(*recorded);
    Frame frame;
    frame.t_s = seconds(ticksOf(observation->timestamp));
    frame.index = frames_;
    frame.image = toGrey(*recorded->image, mrpt::img::CImage::getImagesPathBase());
    FrameReport report = slam_->process(frame);
    ++frames_;
    hasPose_ = report.hasPose();
    if (hasPose_) path_.emplace_back(best(slam_->mixture()).pose());
    return report;
}

bool MonocularKFSLAM::hasPose() const
{
    return hasPose_;
}

void MonocularKFSLAM::getCurrentCameraPose(CPose3DQuatPDFGaussian& pose) const
{
    if (!hasPose_) throw std::logic_error("MonocularKFSLAM: there is no pose yet");
    const Belief& belief = best(slam_->mixture());
    const Vector7d p = belief.pose();
    for (int i = 0; i < 7; ++i) pose.mean[static_cast<unsigned>(i)] = p[i];
    pose.cov.asEigen() = belief.P.topLeftCorner<7, 7>();
}

void MonocularKFSLAM::getCurrentState(CPose3DQuatPDFGaussian& pose,
                                      std::vector<TPoint3D>& landmarks,
                                      std::map<unsigned int, CLandmark::TLandmarkID>& ids,
                                      CVectorDouble& x, CMatrixDouble& P) const
{
    getCurrentCameraPose(pose);
    landmarks.clear();
    ids.clear();
    for (const MapLandmark& landmark : slam_->map())
    {
        const auto point = pointOf(landmark);
        if (!point) continue;
        ids[static_cast<unsigned int>(landmarks.size())] =
            static_cast<CLandmark::TLandmarkID>(landmark.id);
        landmarks.emplace_back(point->p.x(), point->p.y(), point->p.z());
    }
    const Belief& belief = best(slam_->mixture());
    x.resize(static_cast<std::size_t>(belief.size()));
    x.asEigen() = belief.x;
    P.setSize(belief.size(), belief.size());
    P.asEigen() = belief.P;
}

void MonocularKFSLAM::getCurrentState(CPose3DPDFGaussian& pose, std::vector<TPoint3D>& landmarks,
                                      std::map<unsigned int, CLandmark::TLandmarkID>& ids,
                                      CVectorDouble& x, CMatrixDouble& P) const
{
    CPose3DQuatPDFGaussian withQuaternion;
    getCurrentState(withQuaternion, landmarks, ids, x, P);
    pose = CPose3DPDFGaussian(withQuaternion);
}

void MonocularKFSLAM::getAs3DObject(mrpt::opengl::CSetOfObjects::Ptr& objects) const
{
    const auto drawn = mapObjects(path_, slam_ ? slam_->map() : std::vector<MapLandmark>{});
    objects->clear();
    for (const auto& object : *drawn) objects->insert(object);
}
}  // namespace monoslam
