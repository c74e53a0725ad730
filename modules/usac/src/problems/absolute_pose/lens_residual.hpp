// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LENS_RESIDUAL_HPP
#define OPENCV_USACV20_LENS_RESIDUAL_HPP

#include "problems/absolute_pose/camera.hpp"
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Reprojection error in the original, distorted image.

A datum is an object point and an image point converted by PoseCamera::toSearchUnits. If there are
covariances (Params::sigmas), the root of the image point's covariance follows, see Correspondences,
and errors are then in units of their standard deviation. A model is a 3x4 matrix `matrix` [R t],
see PoseCamera. For points that are not in front of the camera and for points that the lens does not
image, squared errors are infinite and the components of the error are 1e100. */
class LensResidual : public Residual
{
public:
    //! @param whitened_ true: there are covariances
    LensResidual(const PoseCamera& camera_, bool whitened_) : camera(camera_), whitened(whitened_)
    {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE;
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE;
    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE;
    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE;

private:
    double squared(const Model& model, const double* const* columns, int i) const;
    bool project(const Model& model, const double* datum, Vec2d& seenAt,
                 Matx<double, 2, 3>* derivative) const;

    const PoseCamera camera;
    const bool whitened;
};

}  // namespace usacv20
}  // namespace cv

#endif
