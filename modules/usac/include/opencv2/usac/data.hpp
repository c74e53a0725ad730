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

//! Maximum sizes, for arrays of fixed length.
enum {
    MAX_SAMPLE_SIZE = 8,  //!< maximum number of points in a minimal sample
    MAX_MODELS = 10,      //!< maximum number of models from one minimal sample
    MAX_MODEL_SIZE = 12,  //!< maximum number of entries of a model
    MAX_COLUMNS = 10      //!< maximum number of columns of Correspondences: four coordinates and
                          //!< the covariances of two image points
};
//! Columns of Correspondences for problems of two views.
enum TwoViewColumn {
    X1,  //!< x coordinate in image 1
    Y1,  //!< y coordinate in image 1
    X2,  //!< x coordinate in image 2
    Y2   //!< y coordinate in image 2
};

/** @brief A model as a matrix of at most #MAX_MODEL_SIZE numbers: a homography, a fundamental or
essential matrix, or the model of any other Problem. It refers to the coordinates of
Correspondences. Converts from and to a Matx of the same size. */
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
    //! True if shape and entries are equal.
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

    double center[3];  //!< center of the points before the normalization
    double scale;      //!< factor applied after the shift
};

/** @brief The correspondences as the components see them: normalized, shuffled, and stored as a
structure of arrays.

A datum (one correspondence) has coordinates[0] numbers from the caller's first array and
coordinates[1] from the second. Each of these numbers has a column of `size` elements: #X1, #Y1,
#X2, #Y2 for two views. For H and F, the points of each image are translated and scaled to about
unit size (for F and for symmetric errors of H with the same scale in both images, so that errors
are scaled by this factor, too). For E, they are on the normalized image plane. The order is
pseudo-random and fixed, so that consecutive points are always a random subset.

If there are Params::sigmas, more columns follow, which describe the noise of each match in units of
`meanSigma`; a residual must divide the error of a match by its standard deviation. For one sigma
per match, there is one column: the factor by which the residual multiplies the error, `meanSigma`
divided by the sigma. For covariances, there are three columns for the last array and, for two
images, three more for the first one: the entries of the root L = [p 0; q s] of the covariance L L^T
of the point, in the coordinates of its own array's columns; p, q and s are divided by `unit`. */
struct Correspondences
{
    //! No correspondences.
    Correspondences()
        : problem(0), size(0), inputSize(0), coordinates(), noise(0), meanSigma(1), column(),
          exact(), inputIndex(0), scores(0), unit(1), threshold(0), lower(), upper()
    {}

    //! Coordinates per datum.
    int columns() const { return coordinates[0] + coordinates[1]; }
    //! Numbers per datum, as a Residual expects them: the coordinates and `noise`.
    int numbers() const { return columns() + noise; }

    const Problem* problem;  //!< kind of model that is estimated
    int size;                //!< number of correspondences whose coordinates are all finite
    int inputSize;           //!< number of rows in the caller's arrays
    int coordinates[2];      //!< numbers per point in each array; 0: there is no second array
    //! Columns that describe the noise of each match; 0: there are no Params::sigmas, 1: factors
    //! of the errors, 3 or 6: covariances of points.
    int noise;
    //! Mean of Params::sigmas, (sum s^d / N)^(1/d) with d = Problem::errorDimension(), where s of a
    //! match with covariances is the standard deviation of isotropic noise with an error of about
    //! the same variance; 1 if there are no sigmas.
    double meanSigma;
    const float* column[MAX_COLUMNS];  //!< single precision for scoring, 64-byte aligned
    const double* exact[MAX_COLUMNS];  //!< double precision for solvers and fits
    const int* inputIndex;             //!< row of each point in the caller's arrays
    const float*
        scores;   //!< Params::scores in the order of the points, lower is better; null: no scores
    double unit;  //!< length of one unit of Params::threshold (meanSigma pixels) in the columns of
                  //!< the last array
    double threshold;  //!< threshold of the search, not squared, in the unit of the columns of the
                       //!< last array; at first Params::threshold times Params::reach
    Frame frame[2];    //!< normalization of each array: from the coordinates of
                       //!< Problem::toModelCoordinates to the columns; if there is only one array,
                       //!< both are equal
    float lower[MAX_COLUMNS];  //!< nearly all values of each column are above this bound
    float upper[MAX_COLUMNS];  //!< nearly all values of each column are below this bound
};

//! The score of a model: the lower the cost, the better.
struct Quality
{
    Quality() : cost(std::numeric_limits<double>::infinity()), inliers(0) {}
    //! Sets both members.
    Quality(double cost_, int inliers_) : cost(cost_), inliers(inliers_) {}
    //! True if this object has a lower cost than `other`.
    bool betterThan(const Quality& other) const { return cost < other.cost; }

    double cost;  //!< sum of a cost between 0 and 1 for each point, but see Score::wholeModel;
                  //!< infinite: there is no model
    int inliers;  //!< number of points with errors of at most Context::inlierThreshold (LMedS: at
                  //!< most the median)
};

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
