// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POINT_CHUNKS_HPP
#define OPENCV_USACV20_POINT_CHUNKS_HPP

#include <type_traits>
#include "opencv2/usac/components.hpp"
#include "residual/kernels.hpp"

namespace cv {
namespace usacv20 {

/** The points of a fit and their weights, gathered once for all its steps, in the chunks that a
SumsKernel takes. */
class PointChunks
{
public:
    //! `count` is at least 1; null `weights` are all 1. More than a few points take memory from the
    //! arena, or from the heap if `arena` is null.
    PointChunks(const Correspondences& points, const int* indices, int count, const double* weights,
                Arena* arena = 0);

    //! The first `count` sums of a kernel over all chunks.
    void sum(SumsKernel kernel, int count, const double* model, double* sums) const;

    //! Gets a point, at most #MAX_COLUMNS numbers, and its weight; false beyond the last one.
    bool get(int index, double* datum, double& weight) const;

private:
    typedef double Row[SUMS_CHUNK];
    enum { TWO_VIEW_ROWS = 5, LOCAL_ROWS = 16 * TWO_VIEW_ROWS };

    template <class Width>
    void gather(const Correspondences& points, const int* indices, const double* weights,
                Width width);

    const int size, chunks, columns;
    Arena own;  //!< used if no arena was given
    Arena::Scope scope;
    Row* rows;  //!< columns and weights of each chunk
    Row few[LOCAL_ROWS];

    PointChunks(const PointChunks&);
    PointChunks& operator=(const PointChunks&);
};

}  // namespace usacv20
}  // namespace cv

#endif
