// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MonoSlam.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "LandmarkFinder.h"
#include "MapKeeper.h"
#include "StartWindow.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr int kSettled = 5;            ///< matches after which a landmark's residual tells of noise
constexpr std::size_t kFewest = 10;    ///< residuals that make a median
constexpr double kMedianChi2 = 1.386;  ///< of chi2(2)
constexpr double kForget = 0.05;       ///< weight of one frame in the running noise
constexpr double kExact = 1e-12;  ///< variance of what defines the world

/** Thread CPU time since the last call [ms]. */
class StageClock
{
   public:
    double lap()
    {
        const double now = read();
        return now - std::exchange(last_, now);
    }

   private:
    static double read()
    {
        std::timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
    }
    double last_ = read();
};

/** Squared post-fit residuals [px^2] of every pair found, right or wrong, of landmarks that have
 *  settled. */
std::vector<double> settledResiduals(const Belief& belief, const Camera& camera,
                                     const std::vector<Association>& associations,
                                     const LandmarkRecords& records)
{
    std::vector<double> squares;
    for (const auto& association : associations)
    {
        const bool found =
            association.fate == Fate::Matched || association.fate == Fate::Rejected;
        const Eigen::Index index = belief.find(association.id);
        const auto record = records.find(association.id);
        if (!found || index < 0 || record == records.end() || record->second.matched < kSettled)
            continue;
        const auto& slot = belief.landmarks[static_cast<std::size_t>(index)];
        const auto pixel = projectPixel(camera, belief.camera(), slot.kind,
                                        belief.x.segment(slot.offset, slot.size()));
        if (pixel) squares.push_back((*pixel - association.z).squaredNorm());
    }
    return squares;
}

double residualRms(const Belief& belief, const Camera& camera,
                   const std::vector<Association>& associations)
{
    double sum = 0.0;
    int count = 0;
    for (const auto& association : associations)
    {
        const Eigen::Index index = belief.find(association.id);
        if (association.fate != Fate::Matched || index < 0) continue;
        const auto& slot = belief.landmarks[static_cast<std::size_t>(index)];
        const auto pixel = projectPixel(camera, belief.camera(), slot.kind,
                                        belief.x.segment(slot.offset, slot.size()));
        if (!pixel) continue;
        sum += (*pixel - association.z).squaredNorm();
        ++count;
    }
    return count > 0 ? std::sqrt(sum / (2.0 * count)) : 0.0;
}
}  // namespace

struct MonoSlam::Impl
{
    Impl(MonoSlamOptions o, const Camera& c, std::unique_ptr<Associator> a, FilterEngine e,
         unsigned seed)
        : options(std::move(o)),
          camera(c),
          associator(std::move(a)),
          engine(std::move(e)),
          rng(seed),
          keeper(options, c, seed)
    {
    }

    MonoSlamOptions options;
    Camera camera;
    std::unique_ptr<Associator> associator;
    FilterEngine engine;
    std::mt19937 rng;
    MapKeeper keeper;
    Mixture mixture;
    double t_s = 0.0;
    bool anyFrame = false;
    int poorFrames = 0;
    std::optional<StartWindow> window;

    std::optional<MetricPose> target;  ///< what the world was defined by
    Eigen::Matrix<double, 6, 6> P_first = Eigen::Matrix<double, 6, 6>::Zero();  ///< of its pose
    double rejectedShare = 0.0;    ///< running mean
    double sigmaFloor2_px2 = 0.0;  ///< of a match, as the residuals say

    bool restarted = false;
    void restart(const FrameContext& context);
    void adaptNoise(const FrameReport& report);
    void refineStart(const FrameContext& context, const FrameReport& report);
    [[nodiscard]] Eigen::Matrix<double, 7, 7> worldCovariance(const Vector7d& pose) const;
    [[nodiscard]] double birthSigma_px() const
    {
        return options.search.subpixel ? 2.0 * options.search.sigma_floor_px
                                       : options.search.sigma_px;
    }

    void check(const Frame& frame) const;
    std::string start(const FrameContext& context, const cv::Mat& image);
    void track(const FrameContext& context, double dt_s, FrameReport& report, StageClock& clock);
    void judge(FrameReport& report);
    void summarize(FrameReport& report) const;
};

void MonoSlam::Impl::check(const Frame& frame) const
{
    const CameraParameters& p = camera.parameters();
    const std::string where = "frame " + std::to_string(frame.index) + ": ";
    if (frame.image.type() != CV_8UC1) throw std::invalid_argument(where + "image is not 8-bit grey");
    if (frame.image.cols != p.width_px || frame.image.rows != p.height_px)
        throw std::invalid_argument(where + "image has " + std::to_string(frame.image.cols) + " x " +
                                    std::to_string(frame.image.rows) + " pixels, the camera has " +
                                    std::to_string(p.width_px) + " x " +
                                    std::to_string(p.height_px));
    if (anyFrame && !(frame.t_s > t_s)) throw std::invalid_argument(where + "time does not increase");
}

/** Puts the first belief up; returns why that is not possible yet. */
std::string MonoSlam::Impl::start(const FrameContext& context, const cv::Mat& image)
{
    const InitializationOptions& init = options.initialization;
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    Matrix13d P_v = kExact * Matrix13d::Identity();
    double rho0 = init.rho0;
    double sigma_rho = init.sigma_rho;
    if (options.metricStart.method != MetricStartMethod::None)
    {
        const MetricStartResult result = findMetricPose(image, camera, options.metricStart);
        if (!result.found) return result.reason;
        target = result.found;
        x_v.head<7>() = target->pose;
        Matrix13d P_target = Matrix13d::Zero();
        P_target.topLeftCorner<7, 7>() = target->P;
        P_first = poseCovariance(x_v, P_target);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const auto& p : target->points_m) middle += p / static_cast<double>(target->points_m.size());
        rho0 = 1.0 / (middle - target->pose.head<3>()).norm();
        sigma_rho = init.relative_sigma_rho * rho0;
    }
    P_v.diagonal().segment<3>(camera_state::kVelocity).setConstant(init.sigma_v * init.sigma_v);
    P_v.diagonal()
        .segment<3>(camera_state::kAngularVelocity)
        .setConstant(init.sigma_omega_radps * init.sigma_omega_radps);
    mixture = {{Belief::ofCamera(x_v, P_v), 0.0}};
    if (target) mixture = keeper.addKnownPoints(std::move(mixture), *target, context);
    mixture = keeper.addFirst(std::move(mixture), context, rho0, sigma_rho);
    if (!options.start.parallax_deg.empty())
        window.emplace(options.start, camera, target.has_value());
    return {};
}

void MonoSlam::Impl::track(const FrameContext& context, double dt_s, FrameReport& report,
                           StageClock& clock)
{
    for (auto& weighted : mixture)
        weighted.belief = engine.predict(std::move(weighted.belief), options.motion, dt_s);
    report.times.predict_ms = clock.lap();

    const Belief expected = best(mixture);
    SearchOptions search = options.search;
    search.sigma_floor_px = std::sqrt(std::max(
        sigmaFloor2_px2, options.search.sigma_floor_px * options.search.sigma_floor_px));
    LandmarkFinder finder(camera, *context.image, search, keeper.records(), expected);
    VisibilityOptions visibility;
    visibility.border_px = options.search.patch_px / 2 + 2.0;
    visibility.sigma_px = birthSigma_px();
    FrameView view;
    view.predict = [&](const Belief& belief)
    { return predictMeasurements(belief, camera, visibility); };
    view.search = [&](const SearchRegion& region) { return finder.search(region); };
    view.engine = engine;
    Correction correction = associator->correct(std::move(mixture), view, rng);
    mixture = std::move(correction.mixture);
    report.associations = std::move(correction.associations);
    report.counters = correction.counters;
    report.times.search_ms = report.counters.searchMs;
    report.times.associate_ms = report.counters.selectMs;
    report.times.update_ms = clock.lap() - report.counters.searchMs - report.counters.selectMs;
    if (options.search.subpixel) adaptNoise(report);
    report.residualRms_px = residualRms(best(mixture), camera, report.associations);
    for (const auto& association : report.associations)
        if (association.fate == Fate::Matched) ++report.matched;
    mixture = keeper.revise(std::move(mixture), report.associations, context);
}

/** Lets the noise of a match follow the residuals: what calibration, shutter and blur add to a match
 *  differs from camera to camera and is not in the alignment's own covariance. */
void MonoSlam::Impl::adaptNoise(const FrameReport& report)
{
    const double least = options.search.sigma_floor_px * options.search.sigma_floor_px;
    const double most = options.search.max_sigma_floor_px * options.search.max_sigma_floor_px;
    std::vector<double> squares =
        settledResiduals(best(mixture), camera, report.associations, keeper.records());
    if (squares.size() >= kFewest)
    {
        const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
        std::nth_element(squares.begin(), middle, squares.end());
        sigmaFloor2_px2 += kForget * (*middle / kMedianChi2 - sigmaFloor2_px2);
    }
    sigmaFloor2_px2 = std::clamp(sigmaFloor2_px2, least, std::max(least, most));
}

/** Re-estimates the first seconds, where a wrong linearisation would stay for ever. */
void MonoSlam::Impl::refineStart(const FrameContext& context, const FrameReport& report)
{
    if (!window || !window->open() || mixture.size() != 1) return;
    Belief& belief = mixture.front().belief;
    window->record(report.t_s, context.index, belief, report.associations, keeper.records(),
                   birthSigma_px());
    auto refined = window->refine(belief, keeper.records(), options.motion);
    if (refined)
    {
        belief = std::move(*refined);
        keeper.keepOnly(belief);
    }
    keeper.setStarting(window->open());
}

/** A new map around the last pose, in the old map's median depth, when nothing matches any more. */
void MonoSlam::Impl::restart(const FrameContext& context)
{
    const Belief& old = best(mixture);
    const double rho0 = keeper.medianRho(old);
    Vector13d x_v = old.camera();
    x_v.tail<6>().setZero();
    Matrix13d P_v = kExact * Matrix13d::Identity();
    const InitializationOptions& init = options.initialization;
    const double sigma_v = init.sigma_v / (init.rho0 > 0.0 ? rho0 / init.rho0 : 1.0);
    P_v.diagonal().segment<3>(camera_state::kVelocity).setConstant(sigma_v * sigma_v);
    P_v.diagonal()
        .segment<3>(camera_state::kAngularVelocity)
        .setConstant(init.sigma_omega_radps * init.sigma_omega_radps);
    mixture = {{Belief::ofCamera(x_v, P_v), 0.0}};
    keeper.keepOnly(best(mixture));
    mixture = keeper.addFirst(std::move(mixture), context, rho0, init.relative_sigma_rho * rho0);
    if (!options.start.parallax_deg.empty()) window.emplace(options.start, camera, false);
    restarted = true;
    poorFrames = 0;
}

void MonoSlam::Impl::judge(FrameReport& report)
{
    report.state = TrackingState::Tracking;
    poorFrames = report.matched < options.map.min_matched ? poorFrames + 1 : 0;
    const AssociationCounters& counters = report.counters;
    if (counters.pairs > 0)
        rejectedShare += kForget * (static_cast<double>(counters.rejected) /
                                        static_cast<double>(counters.pairs) -
                                    rejectedShare);
    const auto degraded = [&report](const std::string& why)
    {
        report.state = TrackingState::Degraded;
        report.remark = why;
    };
    if (window && window->lastInlierRatio() < options.start.accept_inlier_ratio)
        degraded("no estimate explains the pixels of the first seconds");
    if (rejectedShare > options.map.degraded_rejected_share)
        degraded("many pairs rejected over the last frames");
    if (std::sqrt(sigmaFloor2_px2) > options.map.degraded_residual_px)
        degraded("residuals of " + std::to_string(std::sqrt(sigmaFloor2_px2)) + " px");
    if (restarted) degraded("restarted after a loss: pose and scale since then are guesses");
    if (poorFrames == 0) return;
    degraded("only " + std::to_string(report.matched) + " landmarks matched");
    if (poorFrames >= options.map.lost_after) report.state = TrackingState::Lost;
}

/** What the uncertainty of the first pose in the target's world adds to that of a later pose:
 *  dr = dr0 + phi x (r - r0), dtheta = R' phi, phi = R0 dtheta0. The filter holds the first pose fixed,
 *  because a common error of the whole map is what an EKF linearises worst. */
Eigen::Matrix<double, 7, 7> MonoSlam::Impl::worldCovariance(const Vector7d& pose) const
{
    const Eigen::Matrix3d R_w0 = rotationMatrix(target->pose.tail<4>());
    const Eigen::Matrix3d R_wc = rotationMatrix(pose.tail<4>());
    const Eigen::Vector3d d = pose.head<3>() - target->pose.head<3>();
    Eigen::Matrix4d QL;
    (void)quaternionProduct(pose.tail<4>(), Eigen::Vector4d::UnitX(), nullptr, &QL);
    Eigen::Matrix<double, 7, 6> J = Eigen::Matrix<double, 7, 6>::Zero();
    J.topLeftCorner<3, 3>().setIdentity();
    for (Eigen::Index k = 0; k < 3; ++k)
        J.block<3, 1>(camera_state::kPosition, 3 + k) = R_w0.col(k).cross(d);
    J.bottomRightCorner<4, 3>() = 0.5 * QL.rightCols<3>() * R_wc.transpose() * R_w0;
    return J * P_first * J.transpose();
}

void MonoSlam::Impl::summarize(FrameReport& report) const
{
    if (mixture.empty()) return;
    const Belief& belief = best(mixture);
    report.x_v = belief.camera();
    report.P_v = belief.P.topLeftCorner<13, 13>();
    if (target) report.P_v.topLeftCorner<7, 7>() += worldCovariance(report.x_v.head<7>());
    report.landmarks = static_cast<int>(belief.landmarks.size());
    report.visible = static_cast<int>(report.associations.size());
    report.candidates = keeper.candidates();
    report.added = keeper.added();
    report.removed = keeper.removed();
}

MonoSlam::MonoSlam(MonoSlamOptions options, const Camera& camera,
                   std::unique_ptr<Associator> associator, unsigned seed, FilterEngine engine)
    : impl_(std::make_unique<Impl>(std::move(options), camera, std::move(associator),
                                   std::move(engine), seed))
{
}
MonoSlam::~MonoSlam() = default;
MonoSlam::MonoSlam(MonoSlam&&) noexcept = default;
MonoSlam& MonoSlam::operator=(MonoSlam&&) noexcept = default;

FrameReport MonoSlam::process(const Frame& frame)
{
    impl_->check(frame);
    StageClock clock;
    StageClock whole;
    FrameReport report;
    report.t_s = frame.t_s;
    report.index = frame.index;
    const FrameContext context{prepareImage(frame.image, impl_->options.search.smoothing_px),
                               frame.index};
    report.times.prepare_ms = clock.lap();
    const double dt_s = frame.t_s - std::exchange(impl_->t_s, frame.t_s);
    impl_->anyFrame = true;
    if (impl_->mixture.empty())
    {
        report.remark = impl_->start(context, frame.image);
        if (!impl_->mixture.empty()) report.state = TrackingState::Tracking;
    }
    else
    {
        impl_->track(context, dt_s, report, clock);
        impl_->judge(report);
        if (report.state == TrackingState::Lost) impl_->restart(context);
    }
    impl_->refineStart(context, report);
    report.times.map_ms = clock.lap();
    report.times.total_ms = whole.lap();
    impl_->summarize(report);
    return report;
}

const Mixture& MonoSlam::mixture() const { return impl_->mixture; }
const Camera& MonoSlam::camera() const { return impl_->camera; }

std::vector<MapLandmark> MonoSlam::map() const
{
    std::vector<MapLandmark> map;
    if (impl_->mixture.empty()) return map;
    const Belief& belief = best(impl_->mixture);
    for (const auto& slot : belief.landmarks)
    {
        const LandmarkRecord& record = impl_->keeper.records().at(slot.id);
        map.push_back({slot.id, slot.kind, belief.x.segment(slot.offset, slot.size()),
                       belief.P.block(slot.offset, slot.offset, slot.size(), slot.size()),
                       record.matched, record.lastSeen, record.known, record.bornFrame,
                       record.born.uv_px});
    }
    return map;
}
}  // namespace monoslam
