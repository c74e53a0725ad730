// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANT_SCALE_HPP
#define OPENCV_USACV20_SIGNIFICANT_SCALE_HPP

#include <cfloat>

namespace cv {
namespace usacv20 {

/** @brief Standard deviation sigma of the noise of the inliers from the errors alone, for any
threshold.

Inliers are the points within the radius r for which their number is least likely by chance, as in
an a-contrario RANSAC @cite moisan2004probabilistic. A point is within r of a wrong model with
probability p(r) = chance (r / threshold)^degrees, or p(r) is the part of the wrong matches that are
within r, if that is higher (it is much higher if points form clusters). By Chernoff's bound, k or
more of n points are within r by chance with a probability of at most exp(-n D(k/n, p)), D being the
Kullback-Leibler divergence; r minimizes this bound. The points of the sample are inliers anyway and
are left out.

With Gaussian noise and 10 to 100 % inliers, r is 1.7 to 2.4 sigma for one degree of freedom, 2.4 to
2.9 sigma for two (errors in the plane) and 2.9 to 3.2 sigma for three; the median error within r is
then 0.64, 1.15 or 1.52 sigma, to within 3 %, and gives sigma. If half of the inliers are much
closer than the others (on a second plane not far from the first), the result is the sigma of the
closer half.

The radii grow by factors of 1.15 and 1.22, from a quarter of the threshold up to where p is 1. Only
the first #MOST errors are used. */
class SignificantScale
{
public:
    enum { MOST = 2000 };

    struct Found
    {
        double sigma;  //!< 0 if even the lowest bound is not below n^-m: chance explains it
        int inliers;   //!< points within the radius that was found
    };

    /** @param squaredErrors, count squared errors of all points, in random order
    @param wrongErrors, wrongCount squared errors of wrong matches, see wrongErrors()
    @param threshold unit of the radii, not squared
    @param chance probability that a point is within the threshold of a wrong model
    @param degrees degrees of freedom of the error, 1 to 3
    @param sampleSize m points of a minimal sample
    @param widest largest radius that is tried, in thresholds
    @param exactSample the points of the sample, which have hardly any errors if the model was
    computed from them, do not count for the median: with few inliers, sigma would be far too small
    */
    static Found estimate(const float* squaredErrors, int count, const float* wrongErrors,
                          int wrongCount, double threshold, double chance, int degrees,
                          int sampleSize, double widest = DBL_MAX, bool exactSample = false);
};

}  // namespace usacv20
}  // namespace cv

#endif
