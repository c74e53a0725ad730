// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP
#define OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** The residual for one sigma per match: the error of a residual multiplied by a factor, which is a
number of the datum, see Correspondences. Scores, fits, mask and covariance that use this residual
thus weight each match by its noise.
@param residual the residual without weights
@param factor index of the column of the factors */
Ptr<Residual> weightedResidual(const Ptr<Residual>& residual, int factor);

}  // namespace usacv20
}  // namespace cv

#endif
