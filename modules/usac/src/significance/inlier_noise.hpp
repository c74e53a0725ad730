// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_NOISE_HPP
#define OPENCV_USACV20_INLIER_NOISE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief The noise of the inliers of a model, estimated from its errors alone.

SignificantScale separates inliers from wrong matches: inliers are the points within the radius that
is least likely by chance @cite moisan2004probabilistic. Chance is measured by the errors of wrong
matches made of the same points, see wrongErrors(). The model was fitted to these inliers, or
computed from some of them: their errors are smaller than the noise by a factor of sqrt(1 - m /
inliers), where m is the size of a sample, and sigma is corrected for it.

All lengths are in the unit of the threshold of the points. */
struct InlierNoise
{
    double sigma;      //!< standard deviation of an inlier's error in each component; 0: unknown,
                       //!< as the model is no better than chance or has too few inliers
    double threshold;  //!< error that an inlier hardly exceeds
    double part;       //!< fraction of inliers among the points
    int beyond;        //!< number of inliers that tell the noise: beyond those of a sample
};

/** @brief sigma by the median of the inliers' errors; threshold: 2.2 sigma.
@param context, model points and residual, and a model
@param widest upper bound of the radius and of the threshold
@param most use only the first `most` points
@param once inliers in one place of an array count once: copies of a match have the same error,
which may look like small noise */
InlierNoise roughNoise(const Context& context, const Model& model, double widest, int most,
                       bool once);

/** @brief sigma of an ErrorMixture with a tail that is fitted to the errors within a window around
the inliers.

Keypoints on photographs need the tail: its weight is 0.2 to 0.4 there, and 0 with Gaussian noise.
The threshold is the error that 95 % of the inliers of both kinds do not exceed. */
InlierNoise preciseNoise(const Context& context, const Model& model, double widest);

/** @brief Noise of the numbers in a column of the points, in units of that of the last array.

The noise is the same in both images, in the caller's pixels, so that it differs where the arrays
are scaled by different factors. An array without the unit of the threshold has no noise. */
double relativeNoise(const Correspondences& points, int column);

/** @brief Is a threshold too narrow for the noise by more than a factor?

If it is, the errors go on beyond it, and those within it are spread over it: there are more points
within it, compared with those within its half, than if the right threshold were `factor` times as
wide. Matches of another motion or plane, of which few have small errors, are not taken for noise.
The noise is assumed to be Gaussian and equal in all directions in both images, so that the model
may enlarge it in one direction (strongly tilted views); with heavy tails, the answer is no. */
bool errorsGoOn(const Context& context, const Model& model, double threshold, double factor);

}  // namespace usacv20
}  // namespace cv

#endif
