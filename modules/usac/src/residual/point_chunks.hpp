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

/** The points of a fit and their weights, in the layout that a SumsKernel expects. The points are
copied to this layout once for all steps of the fit or, if there are too many of them for the
caches, again and again, one chunk at a time. */
class PointChunks
{
public:
    //! @param indices_, count indices of the points, and the number of indices, at least 1
    //! @param weights_ a weight for each index; null: all weights are 1
    //! @param arena provides the memory for more than a few points; null: the heap is used
    //! The object keeps references to all arguments.
    PointChunks(const Correspondences& points_, const int* indices_, int count,
                const double* weights_, Arena* arena = 0);

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
    //! TWO_VIEW_ROWS: rows of a chunk of points of two images. MAX_ROWS: most rows of a chunk.
    //! LOCAL_ROWS, STORED_ROWS: maximum numbers of rows in `few` and in other memory.
    enum {
        TWO_VIEW_ROWS = 5,
        MAX_ROWS = MAX_COLUMNS + 1,
        LOCAL_ROWS = 16 * TWO_VIEW_ROWS,
        STORED_ROWS = 256 * TWO_VIEW_ROWS
    };

    //! A chunk. @param memory MAX_ROWS rows, which are used if the chunks are not stored
    const Row* chunk(int index, Row* memory) const;
    //! Copies the points of a chunk.
    void copy(int index, Row* chunk) const;
    template <class Width>
    void gather(int first, int here, Width width, Row* chunk) const;
    void weigh(int first, int here, Row* chunk) const;

    const Correspondences& points;
    const int* const indices;
    const double* const weights;  //!< null: all weights are 1
    const int size, chunks;
    const int columns;  //!< numbers of a point, without the factor of the error
    const int stride;   //!< rows of a chunk
    Arena own;          //!< used if the caller has no arena
    Arena::Scope scope;
    Row* rows;            //!< each chunk: the columns and the weights. Null: not stored
    Row few[LOCAL_ROWS];  //!< memory of `rows` if there are only a few points

    PointChunks(const PointChunks&);
    PointChunks& operator=(const PointChunks&);
};

}  // namespace usacv20
}  // namespace cv

#endif
