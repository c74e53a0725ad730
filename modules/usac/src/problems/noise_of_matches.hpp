// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NOISE_OF_MATCHES_HPP
#define OPENCV_USACV20_NOISE_OF_MATCHES_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

// The residuals for Params::sigmas. Scores, fits, mask and covariance that use them weight each
// match by its noise.

/** @brief The residual in units of the noise of each match.
@param residual the residual without noise
@param points the points, for Correspondences::noise
@return `residual` itself if there are no sigmas. If there are covariances, but no formula of
`residual` for them, a cv::Exception is raised. */
Ptr<Residual> residualWithNoise(const Ptr<Residual>& residual, const Correspondences& points);

/** @brief Problem::createImageResidual for a residual with or without noise, in units of the noise
of each match; empty if the problem has no such residual. */
Ptr<Residual> imageResidualWithNoise(const Problem& problem, const Ptr<Residual>& residual,
                                     const Correspondences& points);

//! Raises a cv::Exception if a residual is a built-in one that does not use the covariances of the
//! points.
void checkNoise(const Residual& residual, const Correspondences& points);

}  // namespace usacv20
}  // namespace cv

#endif
