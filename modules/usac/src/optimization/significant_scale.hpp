// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANT_SCALE_HPP
#define OPENCV_USACV20_SIGNIFICANT_SCALE_HPP

#include <cfloat>

namespace cv {
namespace usacv20 {

/** @brief Estimates the standard deviation sigma of the noise of the inliers from the errors, even
if the threshold is far too small or too large for this noise.

Inliers are the points with errors up to a radius r, chosen so that their number is least likely by
chance, as in an a-contrario RANSAC @cite moisan2004probabilistic. A random point is within r of a
wrong model with probability p(r). This probability is the larger of two numbers: `chance` times
(r / threshold)^degrees, and the fraction of artificial wrong matches whose errors are within r (the
second number is much larger if points form clusters). By Chernoff's bound, k or more of n points
are within r by chance with a probability of at most exp(-n D(k/n, p)), where D is the
Kullback-Leibler divergence; r minimizes this bound. The m points of a sample are inliers of every
model computed from the sample; therefore m is subtracted from k and n.

With Gaussian noise and 10 to 100 % inliers, r is 1.7 to 2.4 sigma for one degree of freedom, 2.4 to
2.9 sigma for two (errors in the plane) and 2.9 to 3.2 sigma for three. The median error within r is
then 0.64, 1.15 or 1.52 sigma, to within 3 %; sigma is computed from this median. If half of the
inliers have much smaller errors than the others (for example because the others are on a second
plane near the first), the result is the sigma of the half with smaller errors.

The radii that are tried grow by factors of 1.15 and 1.22 in turn, from 0.31 times the threshold up
to `widest` or to the radius at which p is 1. Only the first #MOST errors of points are used. */
class SignificantScale
{
public:
    enum { MOST = 2000 };

    struct Found
    {
        double sigma;  //!< in the unit of the threshold; 0 if no radius is significant, that is, if
                       //!< the lowest bound is at least n^-m: among up to n^m samples of m points,
                       //!< some wrong model can reach such a bound by chance
        int inliers;   //!< number of points within the radius; 0 if sigma is 0
    };

    /** @param squaredErrors, count squared errors of all points, in random order
    @param wrongErrors, wrongCount squared errors of wrong matches, see wrongErrors() in
    significance/agreement.hpp
    @param threshold unit of the radii, not squared
    @param chance probability that a point is within the threshold of a wrong model
    @param degrees degrees of freedom of the error, 1 to 3
    @param sampleSize number m of points in a minimal sample
    @param widest largest radius that is tried, in thresholds */
    static Found estimate(const float* squaredErrors, int count, const float* wrongErrors,
                          int wrongCount, double threshold, double chance, int degrees,
                          int sampleSize, double widest = DBL_MAX);
};

}  // namespace usacv20
}  // namespace cv

#endif
