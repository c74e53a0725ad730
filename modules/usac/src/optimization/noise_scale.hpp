// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NOISE_SCALE_HPP
#define OPENCV_USACV20_NOISE_SCALE_HPP

#include "optimization/error_mixture.hpp"

namespace cv {
namespace usacv20 {

/** @brief Estimates the standard deviation sigma of the noise of the inliers, in units of the
threshold: an ErrorMixture without a tail is fitted to the errors up to #REACH thresholds.

Only the first #MOST errors are used. With fewer than #LEAST errors, the result is the sigma to
which the threshold corresponds, 1 / thresholdInSigmas(degrees).

A sigma below #leastSigma is returned only if the number of errors between 4 sigma and the threshold
is hardly higher than the expected number of outliers with such errors; the density of outliers is
measured beyond the threshold. If there are more errors, the noise has long tails, or the model does
not fit all points equally well (for example H for a surface that is not quite a plane). A fit with
a small sigma would then fit only a part of the scene, so #leastSigma is returned instead. */
class NoiseScale
{
public:
    /** Errors up to this many thresholds are used. With 2, the errors of estimated H on the scenes
    of doc/structured.md are 17 % larger; with 8, they are 4 % smaller. Other effects are in
    doc/constants.md. */
    enum { REACH = 4 };
    //! Minimum and maximum number of errors that are used. Halving or doubling one of these numbers
    //! changes the time by at most 3 % and the errors of models by at most 1 %.
    enum { LEAST = 20, MOST = 200 };

    //! A sigma below this value (in units of the threshold) is returned only if hasTail() is false.
    //! Without this test, the value would be a lower bound of sigma, and values below 0.27 would
    //! increase the errors of estimated H on photographs, for example 0.1 by 8 %. With the test,
    //! halving or doubling the value increases these errors by 1 %.
    static double leastSigma() { return 0.27; }

    //! @param squaredErrors, count squared errors of the points, in random order
    //! @param threshold inlier threshold, not squared
    //! @param degrees degrees of freedom of the error, 1 to 3
    //! @return sigma in units of the threshold
    static double estimate(const float* squaredErrors, int count, double threshold, int degrees);

private:
    enum {
        BINS = ErrorHistogram::BINS,
        INSIDE = (int)BINS / (int)REACH  //!< number of bins within the threshold
    };

    //! True if there are significantly more errors between 4 sigma and the threshold than outliers
    //! explain. @param members number of errors in each bin
    static bool hasTail(const int* members, double sigma, int degrees);
};

}  // namespace usacv20
}  // namespace cv

#endif
