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

/** The points of a fit and their weights, copied to chunks in the layout that a SumsKernel expects.
They are copied only once for all steps of the fit. */
class PointChunks
{
public:
    //! @param indices, count indices of the points, and the number of indices, at least 1
    //! @param weights a weight for each index; null: all weights are 1
    //! @param arena provides the memory for more than a few points; null: the heap is used
    PointChunks(const Correspondences& points, const int* indices, int count, const double* weights,
                Arena* arena = 0);

    //! Computes the first `count` sums of a kernel over all chunks. If there are factors of the
    //! errors (see Correspondences::noise), the weights are multiplied by the squared factors.
    void sum(SumsKernel kernel, int count, const double* model, double* sums) const;

    //! Computes a number for each point, see LeverageKernel.
    void leverages(LeverageKernel kernel, const double* model, const double* L,
                   double* result) const;

    //! Gets the Correspondences::numbers() numbers of a point, and its original weight, which is
    //! not multiplied by a squared factor. @return false if `index` is beyond the last point
    bool get(int index, double* datum, double& weight) const;

    //! Number of columns of a point; a column of factors of the errors is not counted.
    int width() const { return columns; }

private:
    typedef double Row[SUMS_CHUNK];
    enum { TWO_VIEW_ROWS = 5, LOCAL_ROWS = 16 * TWO_VIEW_ROWS };

    template <class Width>
    void gather(const Correspondences& points, const int* indices, const double* weights,
                Width width);
    void weigh(const double* factors, const int* indices);

    const int size, chunks;
    const int columns;  //!< numbers of a point, without the factor of the error
    const int stride;   //!< rows of a chunk
    Arena own;          //!< used if the caller has no arena
    Arena::Scope scope;
    Row* rows;  //!< each chunk: the columns and the weights; if errors have factors, two more
                //!< rows: the factors, and the weights without the factors
    Row few[LOCAL_ROWS];  //!< memory of `rows` if there are only a few points

    PointChunks(const PointChunks&);
    PointChunks& operator=(const PointChunks&);
};

}  // namespace usacv20
}  // namespace cv

#endif
