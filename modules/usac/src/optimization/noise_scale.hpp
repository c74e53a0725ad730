// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NOISE_SCALE_HPP
#define OPENCV_USACV20_NOISE_SCALE_HPP

#include "optimization/error_mixture.hpp"

namespace cv {
namespace usacv20 {

/** @brief Standard deviation sigma of the noise of the inliers in units of the threshold: an
ErrorMixture without a tail is fitted to the errors within #REACH thresholds.

Only the first #MOST errors are used. With fewer than #LEAST errors, the result is the noise for
which the threshold was chosen, 1 / thresholdInSigmas(degrees).

A sigma below #leastSigma needs evidence: between 4 sigma and the threshold there must be hardly
more errors than outliers explain; their density is measured beyond the threshold. Otherwise the
noise has long tails, or the model does not fit all points equally well (a surface that is not quite
a plane): a fit to the closest points would fit only a part of the scene, and #leastSigma is
returned. */
class NoiseScale
{
public:
    /** Errors up to this many thresholds are used. With 2, errors of H on the scenes of
    doc/structured.md are 17 % larger; with 8, 4 % smaller. Other effects: doc/constants.md. */
    enum { REACH = 4 };
    //! Minimum and maximum number of errors used. Halving or doubling one changes time by at most
    //! 3 % and errors by at most 1 %.
    enum { LEAST = 20, MOST = 200 };

    //! Smallest sigma that needs no evidence, in thresholds. Without the test for evidence, smaller
    //! values would increase errors of H on photographs, by 8 % with 0.1. With the test, halving or
    //! doubling increases errors of H on real pairs by 1 %.
    static double leastSigma() { return 0.27; }

    //! @param squaredErrors `count` of them @param threshold not squared @param degrees 1 to 3
    static double estimate(const float* squaredErrors, int count, double threshold, int degrees);

private:
    enum {
        BINS = ErrorHistogram::BINS,
        INSIDE = (int)BINS / (int)REACH  //!< bins within the threshold
    };

    //! Are there more errors between 4 sigma and the threshold than outliers explain?
    static bool hasTail(const int* members, double sigma, int degrees);
};

}  // namespace usacv20
}  // namespace cv

#endif
