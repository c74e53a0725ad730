// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ERROR_MIXTURE_HPP
#define OPENCV_USACV20_ERROR_MIXTURE_HPP

namespace cv {
namespace usacv20 {

//! base^exponent for a small exponent of at least 1.
inline double power(double base, int exponent)
{
    return exponent > 1 ? base * power(base, exponent - 1) : base;
}

//! Probability density of e^degrees at 0, where e is the length of the error of an inlier with
//! `degrees` degrees of freedom, 1 to 3. (For uniformly distributed outliers, e^degrees is
//! uniform.)
//! @param variance variance of each component of the error
double inlierPeak(double variance, int degrees);

//! Histogram of the errors up to a limit, the window. The bins have equal width; for each bin, the
//! number of its errors (members) and their mean square are stored.
struct ErrorHistogram
{
    //! Number of bins. Halving or doubling it does not change the accuracy.
    enum { BINS = 48 };

    /** @param squaredErrors, count squared errors of points in random order; NaN is left out
    @param unit unit of the errors in the histogram, not squared
    @param window_ largest error that is used, in units of `unit`
    @param most only the first `most` errors within the window are used */
    ErrorHistogram(const float* squaredErrors, int count, double unit, int window_, int most);

    int members[BINS], size;  //!< number of errors in each bin, and in all bins together
    double squares[BINS];     //!< mean squared error in each bin, in squared units
    const int window;
};

/** @brief Inliers and wrong matches in a histogram of errors, separated by the EM algorithm
@cite torr2000mlesac.

The errors of inliers have a half-normal distribution for one degree of freedom, a Rayleigh
distribution for two and a Maxwell distribution for three; those of wrong matches are uniform on a
line, in the plane or in space. The noise of a part of the inliers, the tail, has three times (TAIL)
the standard deviation of the noise of the other inliers, because keypoints on photographs are
sometimes badly located. */
class ErrorMixture
{
public:
    //! @param degrees_ degrees of freedom of an error, 1 to 3
    //! @param variance_, inliers_, tail_ initial values: variance in squared units of the
    //! histogram, inlier ratio, and fraction of the inliers that are in the tail. If tail_ is 0,
    //! this fraction stays 0.
    ErrorMixture(int degrees_, double variance_, double inliers_, double tail_)
        : degrees(degrees_), variance(variance_), inliers(inliers_), tail(tail_)
    {}

    //! Takes `steps` steps of the EM algorithm.
    void fit(const ErrorHistogram& errors, int steps);
    //! Standard deviation of the noise of the inliers that are not in the tail, in the unit of the
    //! histogram.
    double sigma() const;
    //! The error that the fraction `part` of all inliers do not exceed, in the unit of the
    //! histogram.
    double quantile(double part) const;

private:
    void improve(const ErrorHistogram& errors);

    const int degrees;
    double variance, inliers;  //!< variance of the inliers that are not in the tail; inlier ratio
    double tail;               //!< fraction of the inliers that are in the tail
};

}  // namespace usacv20
}  // namespace cv

#endif
