// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DATA_HPP
#define OPENCV_USACV20_DATA_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include <algorithm>
#include <limits>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @name Data that components work on
@{ */

//! Sizes of arrays.
enum {
    MAX_SAMPLE_SIZE = 8,  //!< points in a minimal sample, at most
    MAX_MODELS = 10,      //!< models from a minimal solver, at most
    MAX_MODEL_SIZE = 12,  //!< numbers in a model, at most
    MAX_COLUMNS = 6       //!< numbers in a datum (one correspondence), at most
};
//! Columns of two views, see Correspondences.
enum TwoViewColumn {
    X1,  //!< x of image 1
    Y1,  //!< y of image 1
    X2,  //!< x of image 2
    Y2   //!< y of image 2
};

/** @brief A matrix of at most #MAX_MODEL_SIZE numbers, in the coordinates of Correspondences: a
homography, a fundamental or essential matrix, or whatever model a Problem has. Converts from and to
a Matx of the same size. */
class Model
{
public:
    Model() : rows(0), cols(0), val() {}
    //! A matrix of zeros.
    Model(int rows_, int cols_) : rows(rows_), cols(cols_), val()
    {
        CV_Assert(size() <= MAX_MODEL_SIZE);
    }
    //! Copies the entries of a Matx.
    template <int ROWS, int COLS>
    Model(const Matx<double, ROWS, COLS>& matrix) : rows(ROWS), cols(COLS), val()
    {
        CV_StaticAssert(ROWS * COLS <= MAX_MODEL_SIZE,
                        "a model has at most MAX_MODEL_SIZE numbers");
        std::copy(matrix.val, matrix.val + ROWS * COLS, val);
    }
    //! Converts to a Matx of the same size; any other size raises cv::Exception.
    template <int ROWS, int COLS>
    operator Matx<double, ROWS, COLS>() const
    {
        CV_Assert(rows == ROWS && cols == COLS);
        return Matx<double, ROWS, COLS>(val);
    }

    //! Number of entries.
    int size() const { return rows * cols; }
    //! True for the same shape and numbers.
    bool operator==(const Model& other) const
    {
        return rows == other.rows && cols == other.cols && std::equal(val, val + size(), other.val);
    }
    //! The opposite of operator==.
    bool operator!=(const Model& other) const { return !(*this == other); }
    double& operator()(int row, int col) { return val[row * cols + col]; }  //!< an entry, unchecked
    double operator()(int row, int col) const { return val[row * cols + col]; }  //!< the same

    int rows;                    //!< rows of the matrix; 0: there is no model
    int cols;                    //!< columns of the matrix
    double val[MAX_MODEL_SIZE];  //!< entries row by row, 0 beyond size()
};

class Problem;

//! The normalization of the points of one array: shifted by `-center`, then scaled.
struct Frame
{
    Frame() : scale(1) { std::fill(center, center + 3, 0.); }
    //! The normalization of 2-D points as a matrix for homogeneous coordinates.
    Matx33d matrix() const
    {
        return Matx33d(scale, 0, 0 - scale * center[0], 0, scale, 0 - scale * center[1], 0, 0, 1);
    }

    double center[3];  //!< in the caller's unit
    double scale;      //!< factor applied after the shift: normalized units per caller's unit
};

/** @brief The correspondences as the components see them: normalized, shuffled, structure of
arrays.

A datum (one correspondence) has coordinates[0] numbers from the caller's first array and
coordinates[1] from the second; each number has a column: #X1, #Y1, #X2, #Y2 for two views. H, F:
translated and scaled to about unit size (F: with the same scale in both images, so that errors
scale with it). E: coordinates of the normalized image plane. The order is pseudo-random and fixed,
so that any run of consecutive points is a random sample. Each column has `size` elements.
*/
struct Correspondences
{
    //! Numbers per datum.
    int columns() const { return coordinates[0] + coordinates[1]; }

    const Problem* problem;  //!< what is estimated
    int size;                //!< number of finite correspondences
    int inputSize;           //!< number of rows in the caller's arrays
    int coordinates[2];      //!< numbers per point in either array; 0: there is no second array
    const float* column[MAX_COLUMNS];  //!< single precision for scoring, 64-byte aligned
    const double* exact[MAX_COLUMNS];  //!< double precision for solvers and fits
    const int* inputIndex;             //!< row of each point in the caller's arrays
    const float*
        scores;   //!< Params::scores in the order of the points, lower is better; null: none given
    double unit;  //!< unit of Params::threshold (a pixel, mostly) in the coordinates of array 2
    double threshold;  //!< Params::threshold times Params::reach in these coordinates, not squared
    Frame frame[2];  //!< from the caller's coordinates (E: of the normalized image plane) to these;
                     //!< if there is one array, both entries are the same
    float lower[MAX_COLUMNS];  //!< nearly all values of each column are above this
    float upper[MAX_COLUMNS];  //!< and nearly all are below this
};

//! The score of a model: the lower the cost, the better.
struct Quality
{
    Quality() : cost(std::numeric_limits<double>::infinity()), inliers(0) {}
    //! From known values.
    Quality(double cost_, int inliers_) : cost(cost_), inliers(inliers_) {}
    //! True if this cost is lower.
    bool betterThan(const Quality& other) const { return cost < other.cost; }

    double cost;  //!< sum over all points, each of which contributes between 0 and 1
    int inliers;  //!< points within the threshold
};

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
