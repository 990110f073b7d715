// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/MonoSlamKF.h"

#include <mrpt/bayes/CKalmanFilterCapable.h>

#include <memory>
#include <stdexcept>

#include "WhitenedRow.h"
#include "monoslam_models/quaternion.h"
#include "mrptMatrix13.h"

namespace monoslam
{
namespace
{
using namespace camera_state;
constexpr auto kCamera = camera_state::kSize;

std::size_t indexAt(Eigen::Index offset)
{
    return static_cast<std::size_t>((offset - kCamera) / inverse_depth::kSize);
}

class MonoSlamKF : public mrpt::bayes::CKalmanFilterCapable<13, 2, 6, 0>
{
   public:
    explicit MonoSlamKF(Belief belief) : layout_(std::move(belief))
    {
        for (const LandmarkSlot& slot : layout_.landmarks)
            if (slot.kind != LandmarkKind::InverseDepth)
                throw std::invalid_argument(
                    "MRPT's filter takes inverse-depth landmarks only, no points");
        if (!layout_.clones.empty())
            throw std::invalid_argument("MRPT's filter takes no pose clones");
        rows_.resize(layout_.landmarks.size());
        m_xkk.resize(static_cast<std::size_t>(layout_.size()));
        m_xkk.asEigen() = layout_.x;
        m_pkk.setSize(layout_.size(), layout_.size());
        m_pkk.asEigen() = layout_.P;
        KF_options.method = mrpt::bayes::kfEKFNaive;
    }

    Belief predict(const ConstantVelocityOptions& motion, double dt_s)
    {
        motion_ = motion;
        dt_s_ = dt_s;
        moves_ = true;
        return iterate();
    }

    Belief update(const Prediction& prediction, const std::vector<PixelMeasurement>& pixels)
    {
        for (const PixelMeasurement& pixel : pixels)
        {
            const auto& predicted = prediction.rows.at(static_cast<std::size_t>(pixel.row));
            WhitenedRow& row = rows_[indexAt(predicted.offset)];
            row.measure(pixel.z, pixel.R);
            row.predict(predicted.h, predicted.H_v, predicted.H_y);
        }
        return iterate();
    }

    Belief step(const Camera& camera, const ConstantVelocityOptions& motion, double dt_s,
                const std::vector<LandmarkPixel>& pixels)
    {
        camera_ = &camera;
        for (const LandmarkPixel& pixel : pixels)
        {
            const Eigen::Index index = layout_.find(pixel.id);
            if (index < 0) throw std::invalid_argument("mrptIteration: no such landmark");
            const auto& slot = layout_.landmarks[static_cast<std::size_t>(index)];
            rows_[indexAt(slot.offset)].measure(pixel.z, pixel.R);
        }
        return predict(motion, dt_s);
    }

   private:
    Belief iterate()
    {
        runOneKalmanIteration();
        layout_.x = m_xkk.asEigen();
        layout_.P = m_pkk.asEigen();
        return layout_;
    }

    [[nodiscard]] Vector13d camera() const { return m_xkk.asEigen().head<kCamera>(); }
    void OnGetAction(KFArray_ACT&) const override {}
    void OnTransitionModel(const KFArray_ACT&, KFArray_VEH& x_v, bool& skip) const override
    {
        skip = !moves_;
        x_v.asEigen() = predictConstantVelocity(x_v.asEigen(), dt_s_, motion_).x_v;
    }

    void OnTransitionJacobian(KFMatrix_VxV& F) const override
    {
        F.asEigen() = predictConstantVelocity(camera(), dt_s_, motion_).F;
    }

    void OnTransitionNoise(KFMatrix_VxV& Q) const override
    {
        Q.asEigen() = predictConstantVelocity(camera(), dt_s_, motion_).Q;
    }

    void OnPreComputingPredictions(const vector_KFArray_OBS&,
                                   std::vector<std::size_t>& indices) const override
    {
        indices.clear();
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (rows_[i].observed || camera_) indices.push_back(i);
    }

    void OnObservationModel(const std::vector<std::size_t>& indices,
                            vector_KFArray_OBS& h) const override
    {
        h.resize(indices.size());
        for (std::size_t i = 0; i < indices.size(); ++i)
        {
            WhitenedRow& row = rows_[indices[i]];
            if (camera_) project(indices[i], row);
            h[i].asEigen() = row.h;
        }
    }

    void project(std::size_t index, WhitenedRow& row) const
    {
        const Eigen::Index offset =
            kCamera + inverse_depth::kSize * static_cast<Eigen::Index>(index);
        const Vector6d y = m_xkk.asEigen().segment<inverse_depth::kSize>(offset);
        const auto p = projectLandmark(*camera_, camera(), LandmarkKind::InverseDepth, y);
        if (!p) throw std::invalid_argument("mrptIteration: a landmark is behind the camera");
        row.predict(p->h, p->J_h_xv, p->J_h_y);
    }

    void OnObservationJacobians(std::size_t index, KFMatrix_OxV& H_v,
                                KFMatrix_OxF& H_y) const override
    {
        H_v.asEigen() = rows_[index].H_v;
        H_y.asEigen() = rows_[index].H_y;
    }

    void OnGetObservationNoise(KFMatrix_OxO& R) const override { R.setIdentity(); }

    void OnGetObservationsAndDataAssociation(vector_KFArray_OBS& z, std::vector<int>& association,
                                             const vector_KFArray_OBS&, const KFMatrix&,
                                             const std::vector<std::size_t>&,
                                             const KFMatrix_OxO&) override
    {
        for (std::size_t i = 0; i < rows_.size(); ++i)
        {
            if (!rows_[i].observed) continue;
            z.emplace_back();
            z.back().asEigen() = rows_[i].z;
            association.push_back(static_cast<int>(i));
        }
    }

    void OnNormalizeStateVector() override
    {
        Eigen::Matrix4d J_n_q;
        auto&& x = m_xkk.asEigen();
        auto&& P = m_pkk.asEigen();
        x.segment<4>(kOrientation) = normalizeQuaternion(x.segment<4>(kOrientation), &J_n_q);
        P.middleRows<4>(kOrientation) = J_n_q * P.middleRows<4>(kOrientation).eval();
        P.middleCols<4>(kOrientation) = P.middleCols<4>(kOrientation).eval() * J_n_q.transpose();
    }

    void OnPostIteration() override
    {
        m_pkk.asEigen() = (0.5 * (m_pkk.asEigen() + m_pkk.asEigen().transpose())).eval();
    }

    Belief layout_;
    mutable std::vector<WhitenedRow> rows_;  ///< OnObservationModel is const, and they are its work
    ConstantVelocityOptions motion_;
    double dt_s_ = 0.0;
    bool moves_ = false;              ///< predict, or only correct
    const Camera* camera_ = nullptr;  ///< MRPT predicts all landmarks, or only the observed ones
};
}  // namespace

FilterEngine makeMrptEngine()
{
    FilterEngine engine;
    engine.predict = [](Belief belief, const ConstantVelocityOptions& motion, double dt_s)
    { return MonoSlamKF(std::move(belief)).predict(motion, dt_s); };
    engine.correct = [](const Belief& prior, const Prediction& prediction,
                        const std::vector<PixelMeasurement>& pixels, int*)
    {
        const auto posterior = std::make_shared<const Belief>(
            pixels.empty() ? prior : MonoSlamKF(prior).update(prediction, pixels));
        return PendingUpdate{posterior->x, [posterior](Belief) { return *posterior; }};
    };
    return engine;
}

Belief mrptIteration(Belief belief, const Camera& camera, const ConstantVelocityOptions& motion,
                     double dt_s, const std::vector<LandmarkPixel>& pixels)
{
    return MonoSlamKF(std::move(belief)).step(camera, motion, dt_s, pixels);
}
}  // namespace monoslam
