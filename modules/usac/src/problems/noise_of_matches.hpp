// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NOISE_OF_MATCHES_HPP
#define OPENCV_USACV20_NOISE_OF_MATCHES_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

// The residuals for Params::sigmas. With these residuals, the scores, the fits, the mask and the
// covariance of the model weight each match by its noise.

/** @brief The residual that divides the error of each match by the standard deviation of this
error. The quotient is multiplied by Correspondences::unit, so that thresholds keep their unit.
@param residual the residual that does not use the sigmas
@param points the points, for Correspondences::noise
@return `residual` itself if there are no sigmas. Raises a cv::Exception if there are covariances,
but no version of `residual` that uses them. */
Ptr<Residual> residualWithNoise(const Ptr<Residual>& residual, const Correspondences& points);

/** @brief The result of Problem::createImageResidual, with its errors divided in the same way as by
residualWithNoise(); empty if the problem has no such residual.
@param problem kind of model
@param residual the residual that does not use the sigmas or, if these are covariances, possibly the
result of residualWithNoise()
@param points the points, for Correspondences::noise */
Ptr<Residual> imageResidualWithNoise(const Problem& problem, const Ptr<Residual>& residual,
                                     const Correspondences& points);

//! Raises a cv::Exception if the points have covariances, but `residual` is a built-in residual
//! that does not use them.
void checkNoise(const Residual& residual, const Correspondences& points);

}  // namespace usacv20
}  // namespace cv

#endif
