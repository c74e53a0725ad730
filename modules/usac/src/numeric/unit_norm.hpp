// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_UNIT_NORM_HPP
#define OPENCV_USACV20_UNIT_NORM_HPP

namespace cv {
namespace usacv20 {

//! Frobenius norm, summed in the order of cv::norm in OpenCV 4. OpenCV 5 uses another order, which
//! would change the last bits of the result.
inline double frobeniusNorm(const Matx33d& m)
{
    const double* const v = m.val;
    double sum = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    sum += v[4] * v[4] + v[5] * v[5] + v[6] * v[6] + v[7] * v[7];
    return std::sqrt(sum + v[8] * v[8]);
}

//! A matrix other than zero, scaled to unit Frobenius norm.
inline Matx33d ofUnitNorm(const Matx33d& m) { return m * (1 / frobeniusNorm(m)); }

//! Scales a model to unit Frobenius norm. @return false if its norm is zero or not finite; the
//! model is then unchanged
inline bool toUnitNorm(Matx33d& model)
{
    const double size = frobeniusNorm(model);
    if (!(size > 0 && size <= DBL_MAX))
        return false;
    model *= 1 / size;
    return true;
}

}  // namespace usacv20
}  // namespace cv

#endif
