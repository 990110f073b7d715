// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>

#include "monoslam_association/PixelGaussian.h"

namespace monoslam
{
namespace
{
class DensePixels : public PixelGaussian
{
   public:
    explicit DensePixels(const Prediction& prediction)
        : prediction_(&prediction), mean_(2 * prediction.count())
    {
        for (Eigen::Index i = 0; i < prediction.count(); ++i)
        {
            mean_.segment<2>(2 * i) = prediction.rows[static_cast<std::size_t>(i)].h;
            const Eigen::Matrix2d own = prediction.HPHt.block<2, 2>(2 * i, 2 * i);
            blocks_.emplace_back(0.5 * (own + own.transpose()));
        }
    }

    [[nodiscard]] std::unique_ptr<PixelGaussian> clone() const override
    {
        return std::make_unique<DensePixels>(*this);
    }
    [[nodiscard]] Eigen::Vector2d mean(Eigen::Index row) const override
    {
        return mean_.segment<2>(2 * row);
    }
    [[nodiscard]] Eigen::Matrix2d covariance(Eigen::Index row) const override
    {
        return blocks_[static_cast<std::size_t>(row)];
    }

    void condition(Eigen::Index row, const Eigen::Vector2d& z, const Eigen::Matrix2d& R) override
    {
        const Eigen::LLT<Eigen::Matrix2d> llt(covariance(row) + R);
        Eigen::Matrix<double, Eigen::Dynamic, 2> w = prediction_->HPHt.middleCols<2>(2 * row);
        if (used_ > 0)
            w.noalias() -= W_.leftCols(used_) * W_.block(2 * row, 0, 2, used_).transpose();
        llt.matrixU().solveInPlace<Eigen::OnTheRight>(w);
        mean_ += w * Eigen::Vector2d(llt.matrixL().solve(z - mean(row)));
        for (std::size_t i = 0; i < blocks_.size(); ++i)
        {
            const Eigen::Matrix2d own = w.middleRows<2>(2 * static_cast<Eigen::Index>(i));
            blocks_[i] -= own * own.transpose();
        }
        if (used_ + 2 > W_.cols()) W_.conservativeResize(w.rows(), W_.cols() + kGrowth);
        W_.middleCols<2>(used_) = w;
        used_ += 2;
    }

   private:
    static constexpr Eigen::Index kGrowth = 16;

    const Prediction* prediction_;
    Eigen::VectorXd mean_;
    std::vector<Eigen::Matrix2d> blocks_;
    Eigen::MatrixXd W_;
    Eigen::Index used_ = 0;
};
}  // namespace

std::unique_ptr<PixelGaussian> densePixels(const Prediction& prediction)
{
    return std::make_unique<DensePixels>(prediction);
}
}  // namespace monoslam
