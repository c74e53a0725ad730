// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GROWTH_HPP
#define OPENCV_USACV20_GROWTH_HPP

namespace cv {
namespace usacv20 {

/** @brief How PROSAC's set of the best points grows @cite chum2005matching.

Of T_N = 200 000 uniform samples of N points, or of as many as there are different ones, T_n = T_N
prod_{i<m} (n - i)/(N
- i) would lie within the n best. The set grows from n to n + 1 when the ceiling of that many
samples has been drawn: T'_{n+1} = T'_n + ceil(T_{n+1} - T_n). */
class Growth
{
public:
    Growth(int sampleSize, int pointCount);

    //! From n to n + 1.
    void grow();
    //! Number n of best points.
    int size() const { return n; }
    //! T'_n: this many samples are drawn before the set grows; all of them lie within the n best
    //! points.
    double samples() const { return limit; }
    //! T_n: of uniform samples of the n best points, so many have as many good ones as the T'_n
    //! have at least, on average.
    double uniformSamples() const { return expected; }

private:
    int m, n;
    double expected;  //!< T_n
    double limit;     //!< T'_n
};

//! The growing set of the best points, sample by sample.
class GrowingSet
{
public:
    //! That of no points.
    GrowingSet() : growth(0, 1), total(0), drawn(0) {}
    GrowingSet(int sampleSize, int pointCount)
        : growth(sampleSize, pointCount), total(pointCount), drawn(0)
    {}

    //! Moves on to the next sample.
    void next();
    //! Number n of best points that the sample is drawn from.
    int size() const { return growth.size(); }
    //! True if the sample must contain the n-th point: no earlier sample could.
    bool newest() const { return drawn <= growth.samples() && growth.size() < total; }

private:
    Growth growth;
    int total;
    double drawn;  //!< t
};

}  // namespace usacv20
}  // namespace cv

#endif
