// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_LINE_DISTANCE_HPP
#define OPENCV_USACV20_SAMPLES_LINE_DISTANCE_HPP

#include <algorithm>
#include <cmath>
#include "opencv2/usac.hpp"

namespace custom {

/** The distance of a point of image 2 from the epipolar line of its match in image 1. This error is
suitable if the points of image 1 are exact, for example those of a map. */
class LineDistance : public cv::usacv20::Residual
{
public:
    typedef cv::usacv20::Correspondences Correspondences;
    typedef cv::usacv20::Model Model;

    void squaredErrors(const Correspondences& p, const Model& F, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        using namespace cv::usacv20;
        for (int i = begin; i < end; ++i)
            errors[i - begin] = squared<float>(F, p.column[X1][i], p.column[Y1][i], p.column[X2][i],
                                               p.column[Y2][i]);
    }

    void squaredErrors(const Model& F, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        using namespace cv::usacv20;
        for (int i = 0; i < count; ++i)
            errors[i] = squared<double>(F, c[X1][i], c[Y1][i], c[X2][i], c[Y2][i]);
    }

    //! The signed distance.
    int error(const Model& F, const double* match, double* out) const CV_OVERRIDE
    {
        const cv::Vec3d line = cv::Matx33d(F) * cv::Vec3d(match[0], match[1], 1);
        *out = line.dot(cv::Vec3d(match[2], match[3], 1)) / std::hypot(line[0], line[1]);
        return 1;
    }

    //! The distance and its derivatives. Without this method, the default would compute finite
    //! differences, with 19 calls of error() (one, and two for each of the nine entries).
    int linearize(const Model& F, const double* match, double* out,
                  double* derivative) const CV_OVERRIDE
    {
        const double x1[] = {match[0], match[1], 1}, x2[] = {match[2], match[3], 1};
        const cv::Vec3d line = cv::Matx33d(F) * cv::Vec3d(x1[0], x1[1], 1);
        const double length = std::hypot(line[0], line[1]);
        error(F, match, out);
        for (int row = 0; row < 3; ++row)
            for (int col = 0; col < 3; ++col)
            {
                const double ofLength = row < 2 ? line[row] / length * x1[col] : 0;
                derivative[3 * row + col] = (x2[row] * x1[col] - *out * ofLength) / length;
            }
        return 1;
    }

private:
    template <typename T>
    static T squared(const Model& F, T x1, T y1, T x2, T y2)
    {
        T m[9] = {0};
        std::copy(F.val, F.val + 9, m);
        const T a = m[0] * x1 + m[1] * y1 + m[2], b = m[3] * x1 + m[4] * y1 + m[5];
        const T r = x2 * a + y2 * b + (m[6] * x1 + m[7] * y1 + m[8]);
        return r * r / (a * a + b * b);
    }
};

}  // namespace custom

#endif
