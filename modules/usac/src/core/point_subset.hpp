// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POINT_SUBSET_HPP
#define OPENCV_USACV20_POINT_SUBSET_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Some of the points, copied as the columns that a residual takes.
class PointSubset
{
public:
    void clear()
    {
        for (int k = 0; k < MAX_COLUMNS; ++k)
            columns[k].clear();
    }

    void add(const Correspondences& points, int index)
    {
        for (int k = 0; k < points.columns(); ++k)
            columns[k].push_back(points.exact[k][index]);
    }

    int size() const { return (int)columns[0].size(); }

    //! size() numbers, which the next call overwrites.
    double* squaredErrors(const Residual& residual, const Model& model)
    {
        const double* data[MAX_COLUMNS];
        for (int k = 0; k < MAX_COLUMNS; ++k)
            data[k] = columns[k].data();
        errors.resize(size());
        residual.squaredErrors(model, data, size(), errors.data());
        return errors.data();
    }

private:
    std::vector<double> columns[MAX_COLUMNS], errors;
};

}  // namespace usacv20
}  // namespace cv

#endif
