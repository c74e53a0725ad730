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
noise by a factor of sqrt(1 - m / inliers), where m is the sample size; sigma and the threshold are
corrected for this factor.

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
@param context, model the run, with its points and residual, and the model
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

/** @brief One of the vectors by which the noise of a match is modeled: the noise is the sum of
Correspondences::columns() vectors, each multiplied by an independent random number of variance 1.
The vectors have an entry for each coordinate of the match. Their unit is the standard deviation of
the noise of a coordinate in the last array, for a match of average noise.

Without covariances, the noise is assumed to be the same in both images, in the caller's pixels, so
that each vector has the direction of a coordinate axis; the vectors of the first array are longer
or shorter if the two arrays are scaled by different factors. The vectors of the first array are 0
if the unit of this array is not that of the threshold (Problem::commonUnit).
@param points the points
@param datum Correspondences::numbers() numbers of the match
@param index index of the vector
@param direction output: the vector */
void noiseDirection(const Correspondences& points, const double* datum, int index,
                    double* direction);

/** @brief True if a threshold is too narrow for the noise by a factor of more than `factor`.

The number of points within the threshold is divided by the number within half of it; the size of a
minimal sample is subtracted from both numbers. If the threshold is too narrow, the errors continue
beyond it, and this ratio is large. The result is true if the ratio is larger than it would be if
the right threshold were `factor` times as wide. Matches of another motion or plane are not taken
for noise, because few of them have small errors. The noise of the points is assumed to be Gaussian
and, unless there are covariances, equal in all directions in both images; the model may enlarge the
noise in one direction (strongly tilted views). If the noise has heavy tails, the result can be
false even if the threshold is too narrow. */
bool errorsGoOn(const Context& context, const Model& model, double threshold, double factor);

}  // namespace usacv20
}  // namespace cv

#endif
