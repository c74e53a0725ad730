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

/** @brief Lowers the number of inliers and raises the cost of a model as if a subset of the points
had at most `kept` inliers, because the points of the subset are not independent evidence for the
model: they are repetitions of a match, or matches at nearly the same position.

@param kept 1: the inliers of the subset count as one inlier; 0: these inliers do not count, because
a point outside the subset represents them
@param subset the points that depend on each other
@param model the model that was scored
@param quality input and output: inliers and cost of all points. The score must be a sum over the
points, see Score::wholeModel() */
void countOnce(const Context& context, int kept, PointSubset& subset, const Model& model,
               Quality& quality);

}  // namespace usacv20
}  // namespace cv

#endif
