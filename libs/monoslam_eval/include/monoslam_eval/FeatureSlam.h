// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_eval/SimulationOptions.h"
#include "monoslam_eval/export.h"
#include "monoslam_filter/editBelief.h"

namespace monoslam
{
/** Options of ini sections [motion], [target] and [slam]. */
struct MONOSLAM_EVAL_EXPORT FeatureSlamOptions
{
    ConstantVelocityOptions motion;
    TargetOptions target;
    VisibilityOptions visibility{8.0, 0.5};
    UndelayedPrior prior{0.5, 0.25, 0.5};
    double sigma_v_mps = 0.5;         ///< of the first velocity
    double sigma_omega_radps = 0.5;   ///< of the first angular velocity
    double convert_linearity = 0.02;  ///< inverse depth to point below this index; 0 = never

    /** \throw std::invalid_argument naming file, section and key */
    static FeatureSlamOptions from(const mrpt::config::CConfigFileBase& file,
                                   const std::string& fileName);
};

/** What became of one frame. */
struct FeatureReport
{
    double t_s = 0.0;
    Vector13d x_v = Vector13d::Zero();  ///< of the belief of largest weight
    Matrix13d P_v = Matrix13d::Zero();
    int landmarks = 0;                      ///< in the state, new ones included
    std::vector<Association> associations;  ///< see Correction, as those below
    AssociationCounters counters;
    Diversity diversity;
};

/** The pipeline of MonoSlam without images: predict, associate and correct, add landmarks.
 *
 * It begins at the origin, where it knows the target's points. A landmark enters the state, undelayed,
 * with the first feature that is truly its image, as in a real run it is whatever its first pixel
 * shows. None is removed: what a strategy spoils stays in its map. A copy goes on from the same state
 * with the same random numbers. */
class MONOSLAM_EVAL_EXPORT FeatureSlam
{
   public:
    FeatureSlam(const FeatureSlamOptions& options, const Camera& camera,
                std::shared_ptr<const Associator> associator, unsigned seed);

    /** \throw std::invalid_argument if time does not increase, or if the truth of a frame's features
     *  is not known, so that no landmark could begin; the frame is then as if it had not been */
    FeatureReport process(const PixelFrame& frame);

    /** Goes on with another strategy, which takes the mixture as it is. */
    void use(std::shared_ptr<const Associator> associator);

    [[nodiscard]] const Mixture& mixture() const { return mixture_; }

   private:
    void check(const PixelFrame& frame) const;
    [[nodiscard]] Mixture predict(Mixture mixture, double t_s) const;
    [[nodiscard]] Mixture grow(Mixture mixture, const PixelFrame& frame) const;
    [[nodiscard]] FeatureReport report(double t_s, Correction correction) const;

    FeatureSlamOptions options_;
    Camera camera_;
    std::shared_ptr<const Associator> associator_;
    std::mt19937 rng_;
    Mixture mixture_;
    std::optional<double> t_s_;
};
}  // namespace monoslam
