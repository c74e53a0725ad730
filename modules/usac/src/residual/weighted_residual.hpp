// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP
#define OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** The residual for Params::sigmas: the error of a residual multiplied by the factor that follows
the coordinates of a datum, see Correspondences::numbers. Scores, fits, mask and covariance that use
this residual thus weight each match by its noise.
@param residual the residual without weights, or an empty pointer
@param problem the problem of the residual, for the number of coordinates
@param params options
@return `residual` itself if it is empty or if there are no sigmas. */
Ptr<Residual> weightedResidual(const Ptr<Residual>& residual, const Problem& problem,
                               const Params& params);

}  // namespace usacv20
}  // namespace cv

#endif
