// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP
#define OPENCV_USACV20_WEIGHTED_RESIDUAL_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** The residual for one sigma per match. It multiplies the error of another residual by a factor,
Correspondences::meanSigma divided by the sigma of the match. The factor is one of the numbers of
the datum, see Correspondences. With this residual, the scores, the fits, the mask and the
covariance of the model weight each match by its noise.
@param residual the other residual, which does not use the factors
@param factor index of the column of the factors */
Ptr<Residual> weightedResidual(const Ptr<Residual>& residual, int factor);

}  // namespace usacv20
}  // namespace cv

#endif
