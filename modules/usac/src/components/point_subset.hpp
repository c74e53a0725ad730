// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POINT_SUBSET_HPP
#define OPENCV_USACV20_POINT_SUBSET_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! A subset of the points, copied to columns for a residual. The memory is valid until the scope
//! passed to the constructor ends.
class PointSubset
{
public:
    //! An empty subset that can hold `capacity` points.
    PointSubset(const Correspondences& points_, int capacity, Arena::Scope& scope)
        : points(points_), count(0), columns(), errors(scope.take<double>(capacity))
    {
        for (int k = 0; k < points.numbers(); ++k)
            columns[k] = scope.take<double>(capacity);
    }

    void add(int index)
    {
        for (int k = 0; k < points.numbers(); ++k)
            columns[k][count] = points.exact[k][index];
        ++count;
    }

    int size() const { return count; }

    //! The squared errors of the size() points; the next call overwrites them.
    const double* squaredErrors(const Residual& residual, const Model& model)
    {
        residual.squaredErrors(model, columns, count, errors);
        return errors;
    }

private:
    const Correspondences& points;
    int count;
    double *columns[MAX_COLUMNS], *const errors;
};

/** @brief Points that are not independent evidence for a model, for example matches to nearly the
same position: all their inliers together count as one inlier.

The points are copied, because models are scored on them often. */
class DependentPoints
{
public:
    //! @param memory an Arena or a scope of it
    template <class Memory>
    DependentPoints(const Correspondences& points_, int capacity, Memory& memory)
        : points(points_), copies(points_)
    {
        copies.size = 0;
        for (int k = 0; k < points.numbers(); ++k)
        {
            copies.column[k] = single[k] = memory.template take<float>(capacity);
            copies.exact[k] = exact[k] = memory.template take<double>(capacity);
        }
    }

    void add(int index)
    {
        for (int k = 0; k < points.numbers(); ++k)
        {
            single[k][copies.size] = points.column[k][index];
            exact[k][copies.size] = points.exact[k][index];
        }
        ++copies.size;
    }

    //! Lowers the number of inliers and raises the cost of a model, which were computed from all
    //! points. The score must be a sum over the points, see Score::wholeModel().
    void countOnce(const Context& context, const Model& model, Quality& quality) const;

private:
    Quality rate(const Context& context, const Model& model) const;

    const Correspondences& points;
    Correspondences copies;
    float* single[MAX_COLUMNS];
    double* exact[MAX_COLUMNS];
};

}  // namespace usacv20
}  // namespace cv

#endif
