// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANT_SCALE_HPP
#define OPENCV_USACV20_SIGNIFICANT_SCALE_HPP

#include <cfloat>

namespace cv {
namespace usacv20 {

/** @brief Standard deviation of the noise of the inliers from the errors alone, whatever the
threshold is.

Inliers are the points within the r at which they are the least likely by chance: a point is within
r of a wrong model with the probability p(r) = chance (r / threshold)^degrees, or as often as points
of other matches are if that is more (where points are in clusters, p(r) is far from that of points
anywhere), and by Chernoff's bound k of n points are so at most with the probability exp(-n D(k/n,
p)), D being the divergence of Kullback and Leibler; r has the least bound, as in an a-contrario
RANSAC @cite moisan2004probabilistic. With Gaussian noise that is 2.4 to 2.9 sigma for two degrees
of freedom (errors in the plane), 1.7 to 2.4 sigma for one and 2.9 to 3.2 sigma for three, with 10
to 100 % of inliers, so their median is 1.15, 0.64 or 1.52 sigma, up to 3 %. It is the median that
gives the scale: where half of the inliers are much closer than others (a second plane, not far from
the first), it is that half's. The points of the sample are inliers anyway and do not count for the
bound.

The radii grow by factors of 1.15 and 1.22, from a quarter of the threshold up to where p is 1. At
most #MOST errors are looked at, the first ones. */
class SignificantScale
{
public:
    enum { MOST = 2000 };

    struct Found
    {
        double sigma;  //!< 0 where even the least bound would be met by one of the n^m samples
        int inliers;   //!< points within the radius that was found
    };

    /** @param squaredErrors, count of all points under the model, in random order
    @param wrongErrors, wrongCount the same of points paired with those of other matches
    @param threshold unit of the radii, not squared
    @param chance that a point is within the threshold of a wrong model
    @param degrees of freedom of the error, 1 to 3
    @param sampleSize m points of a minimal sample
    @param widest radius that is looked at, in thresholds
    */
    static Found estimate(const float* squaredErrors, int count, const float* wrongErrors,
                          int wrongCount, double threshold, double chance, int degrees,
                          int sampleSize, double widest = DBL_MAX);
};

}  // namespace usacv20
}  // namespace cv

#endif
