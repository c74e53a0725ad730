// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/read_points.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The same points as CV_64F, continuous.
Mat toDouble(const Mat& points, Arena::Scope& scope)
{
    if (points.depth() == CV_64F && points.isContinuous())
        return points;
    Mat values(points.dims, points.size.p, CV_64FC(points.channels()),
               scope.take<double>(points.total() * points.channels()));
    points.convertTo(values, CV_64F);
    return values;
}

Mat transposed(const Mat& values, Arena::Scope& scope)
{
    Mat columns(values.cols, values.rows, CV_64F, scope.take<double>(values.total()));
    transpose(values, columns);
    return columns;
}

/** Reads any list of points that some function of OpenCV accepts; returns one point per row, one
coordinate per column, CV_64F. In a matrix with one channel, the points are along the longer side
(as for OpenCV's USAC flags), or in the rows if both sides are equal; a single row or column is one
point. Converted data are in memory of the scope. */
Mat readCoordinates(const Mat& points, const char* name, Arena::Scope& scope)
{
    const int rows = points.rows, cols = points.cols, channels = points.channels();
    const bool solid = points.dims == 3 && channels == 1 &&
                       (points.size[0] == 1 || points.size[1] == 1);
    const bool perColumn = channels == 1 &&
                           (cols == 1 || (1 < rows && rows < cols));  // else per row or per element
    const int coordinates = solid          ? points.size[2]
                            : channels > 1 ? channels
                            : perColumn    ? rows
                                           : cols;
    const bool fewCoordinates = solid ||
                                (channels == 1 &&
                                 (rows == 1 || cols == 1));  // OpenCV accepts at most 3 here
    if ((points.dims > 2 && !solid) || coordinates < 2 || (fewCoordinates && coordinates > 3))
        CV_Error_(Error::StsBadArg, ("%s: N points are expected as Nx2, Nx3, 2xN or 3xN with 1 "
                                     "channel or with 2 or 3 channels, "
                                     "not as %dx%d with %d channel(s) and %d dimensions",
                                     name, rows, cols, channels, points.dims));
    const Mat values = toDouble(points, scope);
    if (perColumn)
        return transposed(values, scope);
    return values.reshape(1, (int)(points.total() * channels / coordinates));
}

/** Reads 2-D points. Three coordinates are homogeneous, as for cv::RANSAC; of more, the first two
are used, as for OpenCV's USAC flags. */
Mat readPlanePoints(const Mat& points, const char* name, Arena::Scope& scope)
{
    const Mat values = readCoordinates(points, name, scope);
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
                                         INFINITY);  // which OpenCV treats as finite
    return plane;
}

//! Reads 1-D or 3-D points.
Mat readOtherPoints(const Mat& points, int coordinates, const char* name, Arena::Scope& scope)
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
    const Mat values = toDouble(points, scope);
    return perColumn ? transposed(values, scope) : values.reshape(1, numbers / coordinates);
}

}  // namespace

Mat readPoints(const Mat& points, int coordinates, const char* name, Arena::Scope& scope)
{
    if (points.empty())
        return Mat(0, coordinates, CV_64F);
    return coordinates == 2 ? readPlanePoints(points, name, scope)
                            : readOtherPoints(points, coordinates, name, scope);
}

}  // namespace usacv20
}  // namespace cv
