// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ERROR_MIXTURE_HPP
#define OPENCV_USACV20_ERROR_MIXTURE_HPP

namespace cv {
namespace usacv20 {

//! Density of e^degrees at 0, where e is the error of an inlier with `degrees` degrees of freedom.
double inlierPeak(double variance, int degrees);

//! The errors within a window, in bins of equal width, each represented by the mean square of its
//! errors.
struct ErrorHistogram
{
    //! Number of bins. Halving or doubling it does not change the accuracy.
    enum { BINS = 48 };

    /** @param squaredErrors, count squared errors of points in random order; NaN is left out
    @param unit of the histogram, not squared
    @param window_ largest error, in units
    @param most use only the first `most` errors within the window */
    ErrorHistogram(const float* squaredErrors, int count, double unit, int window_, int most);

    int members[BINS], size;
    double squares[BINS];  //!< mean squared error of the members, in squared units
    const int window;
};

/** @brief Inliers and wrong matches in a histogram of errors, separated by the EM algorithm
@cite torr2000mlesac.

The errors of inliers are half-normal for one degree of freedom, have Rayleigh's distribution for
two, Maxwell's for three; wrong matches are uniform on a line, in the plane, in space. A part of the
inliers may have #TAIL times the noise of the others: keypoints on photographs that are badly
located. */
class ErrorMixture
{
public:
    //! @param degrees degrees of freedom of an error, 1 to 3
    //! @param variance, inliers, tail values to begin with; without a tail (0) there is none later
    ErrorMixture(int degrees_, double variance_, double inliers_, double tail_)
        : degrees(degrees_), variance(variance_), inliers(inliers_), tail(tail_)
    {}

    //! Takes steps of the EM algorithm.
    void fit(const ErrorHistogram& errors, int steps);
    //! Standard deviation of the noise of the inliers that are not in the tail, in units.
    double sigma() const;
    //! The error that a fraction `part` of all inliers do not exceed, in units.
    double quantile(double part) const;

private:
    void improve(const ErrorHistogram& errors);

    const int degrees;
    double variance, inliers;
    double tail;  //!< part of the inliers
};

}  // namespace usacv20
}  // namespace cv

#endif
