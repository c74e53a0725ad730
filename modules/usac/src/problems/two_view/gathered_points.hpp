// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GATHERED_POINTS_HPP
#define OPENCV_USACV20_GATHERED_POINTS_HPP

#include <algorithm>
#include "opencv2/usac/components.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

//! A contiguous copy of at most MOST selected correspondences, for the vectorized kernels.
template <int MOST>
class GatheredPoints
{
public:
    GatheredPoints() : points(), coordinates() {}

    void gather(const Correspondences& p, const int* indices, int count)
    {
        const float* const from[4] = {p.column[X1], p.column[Y1], p.column[X2], p.column[Y2]};
        points = p;
        points.size = std::min(count, (int)MOST);
        for (int k = 0; k < 4; ++k)
            for (int i = 0; i < points.size; ++i)
                coordinates[k][i] = from[k][indices[i]];
        points.column[X1] = coordinates[0];
        points.column[Y1] = coordinates[1];
        points.column[X2] = coordinates[2];
        points.column[Y2] = coordinates[3];
    }

    int size() const { return points.size; }

    const Correspondences& view() const { return points; }

    //! Number of points whose squared error is at most `limit`.
    template <class Error>
    int count(const Model& model, double limit) const
    {
        return sum(kernelsOf<Error>().inliers, model, limit).inliers;
    }

    //! Number of points whose squared error is at most `limit`, and MSAC cost: the sum of
    //! min(1, squared error / `limit`) over all points.
    template <class Error>
    Quality msac(const Model& model, double limit) const
    {
        return sum(kernelsOf<Error>().msac, model, limit);
    }

private:
    Quality sum(FusedKernel kernel, const Model& model, double limit) const
    {
        float m[9];
        toFloat(model, m);
        Quality result(0, 0);
        kernel(points, m, (float)limit, 0, points.size, result);
        return result;
    }

    GatheredPoints(const GatheredPoints&);
    GatheredPoints& operator=(const GatheredPoints&);

    Correspondences points;
    float coordinates[4][MOST];
};

}  // namespace usacv20
}  // namespace cv

#endif
