// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POINT_CHUNKS_HPP
#define OPENCV_USACV20_POINT_CHUNKS_HPP

#include "opencv2/usac/components.hpp"
#include "residuals/kernels.hpp"

namespace cv {
namespace usacv20 {

/** Some of the points and their weights, gathered once for all steps of a fit, in the chunks that a SumsKernel takes.
 */
class PointChunks
{
public:
    //! At least one point; `weights` may be null for ones.
    PointChunks(const Correspondences& points, const int* indices, int count, const double* weights);

    //! The first `count` sums of a kernel over all chunks. `swapped`: images 1 and 2 of two views change roles.
    void sum(SumsKernel kernel, int count, const double* model, bool swapped, double* sums) const;

    //! A point, #MAX_COLUMNS numbers at most, and its weight; false beyond the last one.
    bool get(int index, double* datum, double& weight) const;

private:
    typedef double Row[SUMS_CHUNK];
    enum { TWO_VIEW_ROWS = 5, LOCAL_CHUNKS = 16 };

    AutoBuffer<double, TWO_VIEW_ROWS * SUMS_CHUNK * LOCAL_CHUNKS> rows;  //!< columns and weights of each chunk
    const int size, chunks, columns;
};

}  // namespace usacv20
}  // namespace cv

#endif
