// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DATA_HPP
#define OPENCV_USACV20_DATA_HPP

#ifndef OPENCV_BINDING_PARSER  // nothing here is for other languages

#include <algorithm>
#include <limits>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @name What components work on
@{ */

//! Bounds of arrays.
enum {
    MAX_SAMPLE_SIZE = 8,  //!< most points of a minimal sample
    MAX_MODELS = 10,      //!< most models of a minimal solver
    MAX_MODEL_SIZE = 12,  //!< most numbers of a model
    MAX_COLUMNS = 6       //!< most numbers of a datum
};
//! Columns of two views, see Correspondences.
enum TwoViewColumn {
    X1,  //!< x of image 1
    Y1,  //!< y of image 1
    X2,  //!< x of image 2
    Y2   //!< y of image 2
};

/** @brief A matrix of at most #MAX_MODEL_SIZE numbers, in the coordinates of Correspondences: a
homography, fundamental or essential matrix, or what another Problem says. It is made of a Matx and
turns into one of the same size. */
class Model
{
public:
    Model() : rows(0), cols(0), val() {}
    //! Zeros.
    Model(int rows_, int cols_) : rows(rows_), cols(cols_), val()
    {
        CV_Assert(size() <= MAX_MODEL_SIZE);
    }
    //! The numbers of a Matx.
    template <int ROWS, int COLS>
    Model(const Matx<double, ROWS, COLS>& matrix) : rows(ROWS), cols(COLS), val()
    {
        CV_StaticAssert(ROWS * COLS <= MAX_MODEL_SIZE,
                        "a model has at most MAX_MODEL_SIZE numbers");
        std::copy(matrix.val, matrix.val + ROWS * COLS, val);
    }
    //! A Matx of the same size; another one raises cv::Exception.
    template <int ROWS, int COLS>
    operator Matx<double, ROWS, COLS>() const
    {
        CV_Assert(rows == ROWS && cols == COLS);
        return Matx<double, ROWS, COLS>(val);
    }

    //! How many numbers.
    int size() const { return rows * cols; }
    //! The same shape and numbers?
    bool operator==(const Model& other) const
    {
        return rows == other.rows && cols == other.cols && std::equal(val, val + size(), other.val);
    }
    //! Not operator==.
    bool operator!=(const Model& other) const { return !(*this == other); }
    double& operator()(int row, int col) { return val[row * cols + col]; }  //!< an entry, unchecked
    double operator()(int row, int col) const { return val[row * cols + col]; }  //!< the same

    int rows;                    //!< of the matrix; 0: there is no model
    int cols;                    //!< of the matrix
    double val[MAX_MODEL_SIZE];  //!< row by row, 0 beyond size()
};

class Problem;

//! How the points of one array have been moved: by `-center`, then scaled.
struct Frame
{
    Frame() : scale(1) { std::fill(center, center + 3, 0.); }
    //! Of points of a plane, as a map of homogeneous coordinates.
    Matx33d matrix() const
    {
        return Matx33d(scale, 0, 0 - scale * center[0], 0, scale, 0 - scale * center[1], 0, 0, 1);
    }

    double center[3];  //!< in the caller's units
    double scale;      //!< new units in one of the caller's
};

/** @brief The correspondences as the components see them: scaled, shuffled, structure of arrays.

A datum has coordinates[0] numbers of the caller's first array and coordinates[1] of the second one,
each number is a column: #X1, #Y1, #X2, #Y2 of two views. H, F: translated and scaled to about unit
size (F, E: the same scale in both images, so that errors scale with it). E: coordinates of the
normalized image plane. The order is pseudo-random and fixed, so that any run of consecutive points
is a random sample. Each column has `size` elements.
*/
struct Correspondences
{
    //! Numbers of a datum.
    int columns() const { return coordinates[0] + coordinates[1]; }

    const Problem* problem;            //!< what is estimated
    int size;                          //!< finite correspondences
    int inputSize;                     //!< rows that the caller gave
    int coordinates[2];                //!< of a point of either array; 0: there is no second one
    const float* column[MAX_COLUMNS];  //!< for scoring, 64-byte aligned
    const double* exact[MAX_COLUMNS];  //!< the same for solving and refinement
    const int* inputIndex;             //!< row of the caller's arrays
    const float*
        scores;        //!< Params::scores in this order, lower is better; null if none were given
    double threshold;  //!< Params::threshold times Params::reach in these coordinates, not squared
    Frame frame[2];  //!< from the caller's (E: normalized) coordinates to these; a single one twice
    float lower[MAX_COLUMNS];  //!< nearly all of each column lies above this
    float upper[MAX_COLUMNS];  //!< and below this
};

//! What a model is worth: the lower the cost, the better.
struct Quality
{
    Quality() : cost(std::numeric_limits<double>::infinity()), inliers(0) {}
    //! Of a sum that is known.
    Quality(double cost_, int inliers_) : cost(cost_), inliers(inliers_) {}
    //! Costs less?
    bool betterThan(const Quality& other) const { return cost < other.cost; }

    double cost;  //!< sum over all points, each between 0 and 1
    int inliers;  //!< points within the threshold
};

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
