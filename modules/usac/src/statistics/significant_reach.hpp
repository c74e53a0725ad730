// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANT_REACH_HPP
#define OPENCV_USACV20_SIGNIFICANT_REACH_HPP

namespace cv {
namespace usacv20 {

/** @brief The threshold at which the inliers of a model are the least likely by chance, from the errors alone.

A point is an inlier of a wrong model within r with the probability p(r) = chance (r / threshold)^degrees. By Chernoff's bound, that
k of n points are has at most the probability exp(-n D(k/n, p)), D being the divergence of Kullback and Leibler. The r of
the least bound is returned, as in an a-contrario RANSAC @cite moisan2004probabilistic: with Gaussian noise of standard deviation sigma
2.4 to 2.9 sigma for two degrees of freedom (errors in the plane), 1.7 to 2.4 sigma for one, with 10 to 100 % of inliers. The
points of the sample are inliers anyway and do not count.

The radii grow by factors of 1.15 and 1.22, from a quarter of the threshold up to where p is 1. At most #MOST errors are looked at,
the first ones. */
class SignificantReach
{
public:
    enum { MOST = 2000 };

    /** @param squaredErrors, count of all points under the model, in random order
    @param threshold unit of the radii, not squared
    @param chance that a point is within the threshold of a wrong model
    @param degrees of freedom of the error, 1 or 2
    @param sampleSize m points of a minimal sample
    @return r, 0 where even the least bound would be met by one of the n^m samples */
    static double find(const float* squaredErrors, int count, double threshold, double chance, int degrees, int sampleSize);
};

} // namespace usacv20
} // namespace cv

#endif
