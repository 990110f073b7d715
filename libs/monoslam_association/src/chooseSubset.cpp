// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/chooseSubset.h"

#include <Eigen/Cholesky>
#include <memory>

#include "bestCandidates.h"
#include "monoslam_association/PixelGaussian.h"
#include "monoslam_association/informationGain.h"

namespace monoslam
{
namespace
{
/** Joint Gaussian of camera pose and pixels, conditioned on pixels whose values do not matter. */
class PoseAndPixels
{
   public:
    PoseAndPixels(const Belief& belief, const Prediction& prediction)
        : prediction_(prediction),
          pose_(belief.pose()),
          P_xx_(belief.P.topLeftCorner<7, 7>()),
          C_(prediction.PHt.topRows<7>()),
          W_(2 * prediction.count(), 0)
    {
        for (Eigen::Index i = 0; i < prediction.count(); ++i)
            S_.push_back(prediction.rows[static_cast<std::size_t>(i)].S);
    }

    /** Index in \p rows of the most informative one, or nothing tells anything: rows.size(). */
    [[nodiscard]] std::size_t best(const std::vector<Eigen::Index>& rows) const
    {
        const PoseInformation information(pose_, P_xx_);
        std::size_t best = rows.size();
        double most = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            const auto row = static_cast<std::size_t>(rows[i]);
            if (!positiveDefinite(S_[row])) continue;
            const double bits = information(C_.middleCols<2>(2 * rows[i]), S_[row]);
            if (bits <= most) continue;
            most = bits;
            best = i;
        }
        return best;
    }

    void condition(Eigen::Index row)
    {
        const Eigen::LLT<Eigen::Matrix2d> llt(S_[static_cast<std::size_t>(row)]);
        Eigen::Matrix<double, 7, 2> c = C_.middleCols<2>(2 * row);
        Eigen::Matrix<double, Eigen::Dynamic, 2> w = prediction_.HPHt.middleCols<2>(2 * row);
        w.noalias() -= W_ * W_.middleRows<2>(2 * row).transpose();
        llt.matrixU().solveInPlace<Eigen::OnTheRight>(c);
        llt.matrixU().solveInPlace<Eigen::OnTheRight>(w);
        P_xx_ -= c * c.transpose();
        C_ -= c * w.transpose();
        for (std::size_t i = 0; i < S_.size(); ++i)
        {
            const Eigen::Matrix2d own = w.middleRows<2>(2 * static_cast<Eigen::Index>(i));
            S_[i] -= own * own.transpose();
        }
        W_.conservativeResize(Eigen::NoChange, W_.cols() + 2);
        W_.rightCols<2>() = w;
    }

   private:
    const Prediction& prediction_;
    Vector7d pose_;
    Eigen::Matrix<double, 7, 7> P_xx_;
    Eigen::Matrix<double, 7, Eigen::Dynamic> C_;
    Eigen::MatrixXd W_;
    std::vector<Eigen::Matrix2d> S_;
};
}  // namespace

std::vector<Eigen::Index> chooseSubset(const Belief& belief, const Prediction& prediction,
                                       std::vector<Eigen::Index> rows, std::size_t count)
{
    std::vector<Eigen::Index> chosen;
    PoseAndPixels joint(belief, prediction);
    while (chosen.size() < count && !rows.empty())
    {
        const std::size_t i = joint.best(rows);
        if (i == rows.size()) break;
        chosen.push_back(rows[i]);
        joint.condition(rows[i]);
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return chosen;
}
}  // namespace monoslam
