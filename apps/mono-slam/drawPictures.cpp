// SPDX-License-Identifier: BSD-3-Clause
#include "drawPictures.h"

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
const cv::Scalar kGreen(60, 220, 60), kRed(40, 40, 255), kYellow(0, 210, 255), kBlue(255, 160, 30),
    kGrey(150, 150, 150), kBlack(0, 0, 0);
constexpr double kRadius99 = 3.0349;  // sqrt of chi2(2, 0.99)

cv::Point2d toPoint2d(const Eigen::Vector2d& p)
{
    return {p.x(), p.y()};
}

cv::Scalar colourOf(Fate fate)
{
    switch (fate)
    {
        case Fate::Matched:
            return kGreen;
        case Fate::Rejected:
            return kRed;
        case Fate::NotFound:
            return kYellow;
        default:
            return kGrey;
    }
}

void drawAssociation(cv::Mat& picture, const Association& a)
{
    const cv::Scalar colour = colourOf(a.fate);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(a.S);
    if (a.S.allFinite() && axes.eigenvalues()[0] > 0)
    {
        const Eigen::Vector2d size = 2 * kRadius99 * axes.eigenvalues().cwiseSqrt();
        const Eigen::Vector2d major = axes.eigenvectors().col(1);
        const double angle_deg = std::atan2(major.y(), major.x()) * 180.0 / CV_PI;
        cv::ellipse(picture,
                    cv::RotatedRect(toPoint2d(a.h),
                                    cv::Size2d(std::min(size[1], 1e4), std::min(size[0], 1e4)),
                                    static_cast<float>(angle_deg)),
                    colour, 1, cv::LINE_AA);
    }
    if (a.fate == Fate::Matched || a.fate == Fate::Rejected)
    {
        cv::drawMarker(picture, toPoint2d(a.z), colour, cv::MARKER_CROSS, 7, 1, cv::LINE_AA);
        cv::line(picture, toPoint2d(a.h), toPoint2d(a.z), colour, 1, cv::LINE_AA);
    }
}

void drawNew(cv::Mat& picture, const FrameReport& report, const MapLandmark& landmark,
             const Camera& camera)
{
    const bool isRay = landmark.kind == LandmarkKind::InverseDepth;
    if (isRay && !(landmark.y[inverse_depth::kRho] > 0)) return;
    const Eigen::Vector3d p_w = isRay ? toPoint(Vector6d(landmark.y)) : Eigen::Vector3d(landmark.y);
    const Eigen::Vector4d q_wc = report.x_v.segment<4>(camera_state::kOrientation).normalized();
    const Eigen::Vector3d r_wc = report.x_v.head<3>();
    const auto uv = camera.project(rotationMatrix(q_wc).transpose() * (p_w - r_wc));
    if (uv && camera.contains(*uv))
        cv::drawMarker(picture, toPoint2d(*uv), kBlue, cv::MARKER_SQUARE, 9, 1, cv::LINE_AA);
}
}  // namespace

cv::Mat drawFrame(const cv::Mat& image, const FrameReport& report,
                  const std::vector<MapLandmark>& added, const Camera& camera)
{
    cv::Mat picture;
    cv::cvtColor(image, picture, cv::COLOR_GRAY2BGR);
    if (report.hasPose())
        for (const auto& landmark : added) drawNew(picture, report, landmark, camera);
    for (const auto& association : report.associations) drawAssociation(picture, association);
    char text[200];
    std::snprintf(text, sizeof text, "%ld  %.3f s  %s  matched %d of %d, rejected %ld  %s",
                  report.index, report.t_s, name(report.state).c_str(), report.matched,
                  report.visible, report.counters.rejected, report.remark.c_str());
    cv::rectangle(picture, {0, 0}, {picture.cols, 18}, kBlack, cv::FILLED);
    cv::putText(picture, text, {4, 13}, cv::FONT_HERSHEY_SIMPLEX, 0.42, cv::Scalar::all(255), 1,
                cv::LINE_AA);
    return picture;
}

void savePicture(const std::string& file, const cv::Mat& picture)
{
    std::vector<unsigned char> bytes;
    cv::imencode(file.substr(file.rfind('.')), picture, bytes);
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw std::runtime_error(file + ": cannot be written (disk full?)");
}
}  // namespace monoslam
