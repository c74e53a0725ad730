// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INLIER_NOISE_HPP
#define OPENCV_USACV20_INLIER_NOISE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief The noise of the inliers of a model, estimated from the errors of the points, without a
known threshold.

SignificantScale separates inliers from wrong matches: inliers are the points within the radius for
which their number is least likely by chance @cite moisan2004probabilistic. What happens by chance
is measured with wrong matches made of the same points, see wrongErrors(). The model was fitted to
the inliers or computed from some of them. Therefore the errors of the inliers are smaller than the
noise by a factor of sqrt(1 - m / inliers), where m is the sample size, and sigma is corrected for
this factor.

All lengths are in the coordinates of the points, like Correspondences::threshold. */
struct InlierNoise
{
    double sigma;      //!< standard deviation of each component of an inlier's error; 0: unknown,
                       //!< because the model is no better than chance or has too few inliers
    double threshold;  //!< estimated inlier threshold: an error that few inliers exceed
    double part;       //!< fraction of inliers among the points
    int beyond;        //!< number of inliers minus the sample size: the larger it is, the more
                       //!< precise sigma is
};

/** @brief Quick estimate: sigma from the median of the inliers' errors, and a threshold of 2.2
sigma.
@param context, model the points and the residual, and the model
@param widest upper bound of the radius of SignificantScale and of the threshold
@param most use only the first `most` points
@param once count inliers with nearly the same position in one of the arrays (the same cell, see
#markRepeated) only once: copies of a match have the same error, which may look like small noise */
InlierNoise roughNoise(const Context& context, const Model& model, double widest, int most,
                       bool once);

/** @brief Precise estimate: sigma of an ErrorMixture with a tail of badly located points. The
mixture is fitted to errors in a range wider than that of the inliers' errors.

The tail is needed for keypoints on photographs: it then contains 20 to 40 % of the inliers, while
Gaussian noise has no tail. The threshold is the error that 95 % of all inliers, including the tail,
do not exceed. With fewer than 50 inliers, no mixture is fitted: sigma is that of roughNoise(), and
the threshold follows from sigma for Gaussian noise. */
InlierNoise preciseNoise(const Context& context, const Model& model, double widest);

/** @brief One of the Correspondences::columns() directions of the noise of a point, as a vector in
the coordinates of the columns. Independent noise of variance 1 along each direction has the
distribution of the noise of the point, if the noise of an average point in the last array is 1.

Without covariances, the noise is assumed to be the same in both images, in the caller's pixels, so
that the directions are the columns, scaled if the arrays are scaled by different factors. There is
no noise in the first array if its unit is not that of the threshold (Problem::commonUnit).
@param points the points
@param datum Correspondences::numbers() numbers of the point
@param index index of the direction
@param direction output */
void noiseDirection(const Correspondences& points, const double* datum, int index,
                    double* direction);

/** @brief True if a threshold is too narrow for the noise by more than `factor`.

The number of points within the threshold is divided by the number within half of it; the points of
a sample are not counted. If the threshold is too narrow, the errors continue beyond it, and this
ratio is large. The result is true if the ratio is larger than it would be if the right threshold
were `factor` times as wide. Matches of another motion or plane are not taken for noise, because few
of them have small errors. The noise of the points is assumed to be Gaussian and equal in all
directions in both images; the model may enlarge the noise in one direction (strongly tilted views).
With heavy tails, the result is false. */
bool errorsGoOn(const Context& context, const Model& model, double threshold, double factor);

}  // namespace usacv20
}  // namespace cv

#endif
