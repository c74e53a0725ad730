// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIDE_BY_SIDE_HPP
#define OPENCV_USACV20_SIDE_BY_SIDE_HPP

#include <algorithm>
#include "opencv2/usac/components.hpp"
#include "residuals/kernels.hpp"

namespace cv {
namespace usacv20 {

//! At most MOST of some correspondences, copied side by side so that the vector kernels can test them.
template <int MOST>
class SideBySide
{
public:
    SideBySide() : points(), coordinates() {}

    void gather(const Correspondences& p, const std::vector<int>& indices)
    {
        const float* const from[4] = {p.x1, p.y1, p.x2, p.y2};
        points = p;
        points.size = std::min((int)indices.size(), (int)MOST);
        for (int k = 0; k < 4; ++k)
            for (int i = 0; i < points.size; ++i)
                coordinates[k][i] = from[k][indices[i]];
        points.x1 = coordinates[0];
        points.y1 = coordinates[1];
        points.x2 = coordinates[2];
        points.y2 = coordinates[3];
    }

    int size() const { return points.size; }

    /** Points whose squared error is at most `limit`. Ends early with clearly less than a third of what `wanted` such points
    of all make likely. */
    int count(Residual::Kind kind, const Model& model, double limit, int wanted = 0) const
    {
        float m[9];
        toFloat(model, m);
        const double rate = (double)wanted / std::max(points.size, 1);
        Quality sum(0, 0);
        for (int begin = 0, end; begin < points.size && !(3 * sum.inliers < rate * begin - 2); begin = end)
        {
            end = std::min(begin + (wanted > 0 ? BLOCK : MOST), points.size);
            kernels().inliers[kind](points, m, (float)limit, begin, end, sum);
        }
        return sum.inliers;
    }

private:
    enum { BLOCK = 16 };

    SideBySide(const SideBySide&);
    SideBySide& operator=(const SideBySide&);

    Correspondences points;
    float coordinates[4][MOST];
};

} // namespace usacv20
} // namespace cv

#endif
