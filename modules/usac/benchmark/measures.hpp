// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MEASURES_HPP
#define OPENCV_USACV20_BENCHMARK_MEASURES_HPP

#include "image_pair.hpp"
#include "method.hpp"

namespace benchmark {

/** Error of an estimate; infinite without a model. Letters stand for problems, see letterOf().

P, R and M: the angle between the estimated and the true rotation in degrees. Other problems: root
mean square over the true correspondences, in pixels, of one of these errors. H, A, S and T:
transfer error, the distance in image 2 between a point mapped by the estimate and its true
counterpart, or the point mapped by the true H if H is the ground truth. F: Sampson distance. E:
Sampson distance of K2^-T E K1^-1. */
double modelError(const ImagePair& pair, ProblemType problem, const cv::Mat& model);

/** Error above which an estimate counts as a failure. H, A, S and T: 1 % of the diagonal of image
2, where the error is measured. F and E: 1 % of the mean of both diagonals. P, R and M: 5 degrees
(see MotionKind for a second condition). */
double failureLimit(const ImagePair& pair, ProblemType problem);

/** A cost like those that estimators minimize, which does not depend on the ground truth: the mean
of min(1, (error / threshold)^2) over all correspondences. The error of a correspondence is its
transfer error or Sampson distance, see modelError (P: reprojection error, with cost 1 for a point
behind the camera; R, M: distance in space 2). 1 without a model. If a bad estimate has a higher
cost than a good one, a longer search can improve it.
@param threshold pixels; R, M: in the unit of space 2 */
double modelCost(const ImagePair& pair, ProblemType problem, const cv::Mat& model,
                 double threshold);

/** F and E: the larger of two angles in degrees, between the estimated and the true rotation, and
between the estimated and the true direction of the translation. P, R and M: only the angle between
the rotations. 180 without a model.

Of the four poses of E (F: of K2^T F K1), the one with the most inliers in front of both cameras is
used, or the one with the most correspondences there if the estimate has no inliers. Opposite
translations differ by 180 degrees. Negative if the problem has no pose, or if the true pose is not
known.
*/
double poseError(const ImagePair& pair, ProblemType problem, const Estimate& estimate);

}  // namespace benchmark

#endif
