// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NOISE_SCALE_HPP
#define OPENCV_USACV20_NOISE_SCALE_HPP

namespace cv {
namespace usacv20 {

/** @brief Standard deviation of the noise of the inliers in units of the threshold, by expectation
and maximization.

The errors within #REACH thresholds are a mixture of those of inliers (half normal for one degree of
freedom, Rayleigh's distribution for two, Maxwell's for three) and of outliers (uniform in the same
sense) @cite torr2000mlesac. At most #MOST errors are looked at, the first ones, in #BINS bins of
equal width, each by the mean square of its errors. With fewer than #LEAST of them the noise that
the threshold stands for is returned, 1 / thresholdInSigmas(degrees).

Noise that is less than #leastSigma needs evidence: that next to no error lies between four of its
standard deviations and the threshold, but those that outliers explain, whose density shows beyond
the threshold. Else the noise has long tails, or the model does not fit all of the points alike (a
surface that is not quite a plane): then a fit to the closest points would be one to a part of the
scene, and #leastSigma is returned. */
class NoiseScale
{
public:
    /** Thresholds. 2: errors of H +2 % on the lists, +17 % on structured scenes; 8: -2 and -4 %.
    See doc/constants.md, for the others, too. */
    enum { REACH = 4 };
    //! Errors. Half, double: time within 3 %, errors within 1 %.
    enum { LEAST = 20, MOST = 200 };
    //! Half, double: errors the same.
    enum { BINS = 48 };

    //! Unit: threshold. Measured: errors of H on photographs grow below it, by 8 % at 0.1, without
    //! the test for evidence. Half, double: errors of H +1 % on the lists.
    static double leastSigma() { return 0.27; }

    //! @param squaredErrors `count` squared errors @param threshold not squared @param degrees 1 to
    //! 3
    static double estimate(const float* squaredErrors, int count, double threshold, int degrees);

private:
    enum { INSIDE = (int)BINS / (int)REACH };  //!< bins within the threshold

    //! Is there more between four standard deviations and the threshold than outliers explain?
    static bool hasTail(const int* members, double sigma, int degrees);
};

}  // namespace usacv20
}  // namespace cv

#endif
