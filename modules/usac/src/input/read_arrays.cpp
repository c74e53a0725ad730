// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/read_arrays.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The points as a continuous matrix of depth CV_64F; copied only if necessary.
Mat toDouble(const Mat& points, Arena::Scope& scope)
{
    if (points.depth() == CV_64F && points.isContinuous())
        return points;
    Mat values(points.dims, points.size.p, CV_64FC(points.channels()),
               scope.take<double>(points.total() * points.channels()));
    points.convertTo(values, CV_64F);
    return values;
}

bool isFloat(const Mat& points) { return points.depth() == CV_32F && points.isContinuous(); }

Mat transposed(const Mat& values, Arena::Scope& scope)
{
    Mat columns(values.cols, values.rows, CV_64F, scope.take<double>(values.total()));
    transpose(values, columns);
    return columns;
}

/** Reads a list of points in any layout that some function of OpenCV accepts. Returns a matrix with
one point per row and one coordinate per column, CV_64F. In a matrix with one channel, the longer
side is the number of points (as for OpenCV's USAC flags); if both sides are equal, each row is a
point. However, a single row or a single column is one point. Converted data are in memory of the
scope. */
Mat readCoordinates(const Mat& points, const char* name, Arena::Scope& scope, bool floats)
{
    const int rows = points.rows, cols = points.cols, channels = points.channels();
    const bool solid = points.dims == 3 && channels == 1 &&
                       (points.size[0] == 1 || points.size[1] == 1);
    // true: each column is a point; false: each row or each element is a point
    const bool perColumn = channels == 1 && (cols == 1 || (1 < rows && rows < cols));
    const int coordinates = solid          ? points.size[2]
                            : channels > 1 ? channels
                            : perColumn    ? rows
                                           : cols;
    const bool fewCoordinates = solid ||
                                (channels == 1 &&
                                 (rows == 1 || cols == 1));  // at most 3 coordinates are accepted
    if ((points.dims > 2 && !solid) || coordinates < 2 || (fewCoordinates && coordinates > 3))
        CV_Error_(Error::StsBadArg, ("%s: N points are expected as Nx2, Nx3, 2xN or 3xN with 1 "
                                     "channel or with 2 or 3 channels, "
                                     "not as %dx%d with %d channel(s) and %d dimensions",
                                     name, rows, cols, channels, points.dims));
    const Mat values = floats && !perColumn && coordinates == 2 && isFloat(points)
                           ? points
                           : toDouble(points, scope);
    if (perColumn)
        return transposed(values, scope);
    return values.reshape(1, (int)(points.total() * channels / coordinates));
}

/** Reads 2-D points. Points with three coordinates are homogeneous, as for cv::RANSAC. If points
have more coordinates, only the first two are used, as for OpenCV's USAC flags. */
Mat readPlanePoints(const Mat& points, const char* name, Arena::Scope& scope, bool floats)
{
    const Mat values = readCoordinates(points, name, scope, floats);
    if (values.cols == 2)
        return values;
    Mat plane(values.rows, 2, CV_64F, scope.take<double>(2 * (size_t)values.rows));
    if (values.cols > 3)
    {
        values.colRange(0, 2).copyTo(plane);
        return plane;
    }
    Mat points2 = plane.reshape(2);
    convertPointsFromHomogeneous(values, points2);
    for (int i = 0; i < plane.rows; ++i)
        if (values.at<double>(i, 2) == 0)
            points2.at<Vec2d>(i) = Vec2d(INFINITY,
                                         INFINITY);  // a point at infinity; OpenCV's conversion
                                                     // returns a finite point
    return plane;
}

//! Reads 1-D or 3-D points.
Mat readOtherPoints(const Mat& points, int coordinates, const char* name, Arena::Scope& scope,
                    bool floats)
{
    const bool perColumn = points.dims == 2 && points.channels() == 1 &&
                           points.cols != coordinates && points.rows == coordinates;
    const int numbers = (int)points.total() * points.channels();
    const bool perElement = points.channels() == coordinates;
    const bool perRow = points.channels() == 1 && points.size[points.dims - 1] == coordinates;
    if (!perColumn && !perElement && !perRow)
        CV_Error_(Error::StsBadArg,
                  ("%s: N points are expected as Nx%d or %dxN with 1 channel or with %d channels, "
                   "not as %dx%d with %d channel(s) and %d dimensions",
                   name, coordinates, coordinates, coordinates, points.rows, points.cols,
                   points.channels(), points.dims));
    const Mat values = floats && !perColumn && isFloat(points) ? points : toDouble(points, scope);
    return perColumn ? transposed(values, scope) : values.reshape(1, numbers / coordinates);
}

}  // namespace

Mat readPoints(const Mat& points, int coordinates, const char* name, Arena::Scope& scope,
               bool floats)
{
    if (points.empty())
        return Mat(0, coordinates, CV_64F);
    return coordinates == 2 ? readPlanePoints(points, name, scope, floats)
                            : readOtherPoints(points, coordinates, name, scope, floats);
}

Matx33d readCamera(InputArray array, const char* name)
{
    Mat camera = array.getMat();
    if (camera.rows != 3 || camera.cols != 3 || camera.channels() != 1)
        CV_Error_(Error::StsBadArg, ("%s: a 3x3 matrix is expected, not %dx%d with %d channel(s)",
                                     name, camera.rows, camera.cols, camera.channels()));
    Matx33d K;
    camera.convertTo(Mat(3, 3, CV_64F, K.val), CV_64F);
    const double focalProduct = K(0, 0) * K(1, 1);
    if (!checkRange(Mat(3, 3, CV_64F, K.val)) || K(0, 0) == 0 || K(1, 1) == 0 || K(2, 0) != 0 ||
        K(2, 1) != 0 || !(std::abs(determinant(K)) > 1e-12 * std::abs(focalProduct * K(2, 2))))
        CV_Error_(
            Error::StsBadArg,
            ("%s: an invertible matrix with focal lengths other than 0 and the last row 0 0 1 "
             "is expected, not fx = %g, "
             "fy = %g, determinant = %g, last row %g %g %g",
             name, K(0, 0), K(1, 1), determinant(K), K(2, 0), K(2, 1), K(2, 2)));
    return K * (1 / K(2, 2));  // a multiple of K describes the same camera
}

Mat readDistortion(InputArray array, const char* name)
{
    const Mat coefficients = array.getMat();
    if (coefficients.empty())
        return Mat();
    const size_t count = coefficients.total();
    const bool known = count == 4 || count == 5 || count == 8 || count == 12 || count == 14;
    if (!known || (coefficients.rows != 1 && coefficients.cols != 1) ||
        coefficients.channels() != 1)
        CV_Error_(Error::StsBadArg,
                  ("%s: 4, 5, 8, 12 or 14 coefficients are expected, not %dx%d with %d channel(s)",
                   name, coefficients.rows, coefficients.cols, coefficients.channels()));
    Mat numbers;
    coefficients.convertTo(numbers, CV_64F);  // not all functions of OpenCV accept CV_16F
    if (!checkRange(numbers))
        CV_Error_(Error::StsBadArg, ("%s: finite coefficients are expected", name));
    return countNonZero(numbers) ? numbers : Mat();
}

}  // namespace usacv20
}  // namespace cv
