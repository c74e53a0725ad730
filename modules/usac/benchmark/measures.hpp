// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MEASURES_HPP
#define OPENCV_USACV20_BENCHMARK_MEASURES_HPP

#include "image_pair.hpp"
#include "method.hpp"

namespace benchmark {

/** Error of an estimate in pixels, root of the mean of squares over the true correspondences;
infinite without a model.

H: transfer error, the distance in image 2 between a point mapped by the estimate and its
counterpart, or between the points mapped by the estimate and by the true H where that is the truth;
A and S: the same. F: Sampson distance. E: the same of K2^-T E K1^-1. P: not pixels, but the angle
between the estimated and the true rotation, degrees; R and M: the same. */
double modelError(const ImagePair& pair, ProblemType problem, const cv::Mat& model);

/** Error above which an estimate is a failure: 1 % of the diagonal of image 2 (H, A, S, whose error
lies in that image) or of the mean of both diagonals (F and E); P, R and M: 5 degrees. */
double failureLimit(const ImagePair& pair, ProblemType problem);

/** What estimators minimize, whatever the truth is: mean of min(1, (error / threshold)^2) over the
correspondences, with the errors of modelError (P: of the reprojection, 1 behind the camera; R, M:
distances in space 2); 1 without a model. Tells an estimate that a longer search would improve from
one that only the truth speaks against.
@param threshold pixels; R, M: in the unit of space 2 */
double modelCost(const ImagePair& pair, ProblemType problem, const cv::Mat& model,
                 double threshold);

/** The larger one of the angles between the estimated and the true rotation and between the
estimated and the true direction of the translation, in degrees; 180 without a model.

Of the four poses of E (F: of K2^T F K1) it takes the one that puts most inliers (without any:
correspondences) in front of both cameras. The sign of the translation counts. Negative: the problem
has no pose, or the pair none that is known.
*/
double poseError(const ImagePair& pair, ProblemType problem, const Estimate& estimate);

}  // namespace benchmark

#endif
