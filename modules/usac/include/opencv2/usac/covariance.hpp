// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COVARIANCE_HPP
#define OPENCV_USACV20_COVARIANCE_HPP

#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @name Uncertainty of a model
These functions propagate the covariance of a model, Report::covariance, to first order
@cite hartley2003multiple (result 5.6): to the entries of the model, to the motion between two
cameras, and to single points. The errors must be so small that the propagated function is nearly
linear over their range. All functions raise cv::Exception for a model that is not a model of the
given problem, and for a covariance that is not d x d, where d is the number of parameters. If the
covariance has NaN entries, so has the result.
@{ */

/** @brief Derivatives of the entries of a model with respect to the parameters of
Report::covariance.

@param problem kind of the model
@param model as #estimateHomography and similar functions return it, any depth
@return n x d, CV_64F: a row for each of the n entries of the model (row by row), a column for each
of the d parameters of Report::covariance. H, F and E are first brought to the scale and sign in
which the estimation returns them.

The parameters of H, F and E are coordinates in an orthonormal basis of the tangent space of the
valid matrices of unit norm (for F, those of rank 2). As H is returned with h33 = 1, the rows for H
are the derivatives of the quotients h_ij / h33. */
CV_EXPORTS_W Mat tangentOfModel(ProblemType problem, InputArray model);

/** @brief Covariance of the entries of a model: T C T^T, where T is the result of #tangentOfModel
and C is `covariance`.

@param problem kind of the model
@param model as #estimateHomography and similar functions return it, any depth
@param covariance Report::covariance, d x d, any depth
@return n x n, CV_64F, of rank d or less */
CV_EXPORTS_W Mat covarianceOfModel(ProblemType problem, InputArray model, InputArray covariance);

/** @brief Covariance of the rotation and of the direction of the translation, from the covariance
of an essential matrix.

@param essential 3x3, any depth: a multiple of [t]x R
@param covariance Report::covariance of the essential matrix, 5 x 5, any depth
@param R 3x3: the rotation from #estimateRelativePose or from cv::recoverPose
@param t 3 numbers: the translation from the same function, of any length
@return 6 x 6, CV_64F, rank 5: the covariance of the rotation vector w in radians, where exp(w) R is
the rotation with its error, and of the vector t / |t|, whose errors are perpendicular to t. Raises
cv::Exception if R is not a rotation, if t is 0, or if [t]x R is not a multiple of the essential
matrix. Deviations up to a Frobenius norm of 1e-6 are accepted (in R R^T, and between essential
matrices of unit norm). */
CV_EXPORTS_W Mat covarianceOfPose(InputArray essential, InputArray covariance, InputArray R,
                                  InputArray t);

/** @brief Uncertainty of a model at given points.

@param problem kind of the model
@param model as #estimateHomography and similar functions return it, any depth
@param covariance Report::covariance, d x d, any depth
@param points1 N points of image 1, in the layouts of #estimateHomography; absolute pose and 3-D
motions: 3-D points, N x 3 or 3 x N with 1 channel, or with 3 channels, any depth
@param points2 F and E: their N counterparts in image 2; not used for other problems
@param cameraMatrix1 3x3, for #ABSOLUTE_POSE and #ESSENTIAL
@param cameraMatrix2 3x3, for #ESSENTIAL; empty: the same as `cameraMatrix1`
@return CV_64F, a row for each point, in squared units of the second array (pixels): homography and
affine maps: N x 4, the 2x2 covariance (row by row) of the mapped point; absolute pose: N x 4, that
of the projected point (without distortion); 3-D motions: N x 9, the 3x3 covariance of the moved
point; F and E: N x 1, the variance of the signed distance of the point of image 2 from its epipolar
line. NaN where the result is not finite.

The result covers the error of the model alone, not the noise of a measured point. Points for E are
in pixels without distortion, as #removeDistortion returns them. */
CV_EXPORTS_W Mat pointCovariance(ProblemType problem, InputArray model, InputArray covariance,
                                 InputArray points1, InputArray points2 = noArray(),
                                 InputArray cameraMatrix1 = noArray(),
                                 InputArray cameraMatrix2 = noArray());

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
