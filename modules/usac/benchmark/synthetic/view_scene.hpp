// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_VIEW_SCENE_HPP
#define OPENCV_USACV20_BENCHMARK_VIEW_SCENE_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! A synthetic view of object points.
struct ViewOptions
{
    ViewOptions()
        : inliers(200), outliers(100), duplicates(0), noise(0.5), onPlane(false), thickness(0),
          distortion(0), outlierModel(opencv_test::OUTLIERS_UNIFORM), scoreInformation(0.5), seed(1)
    {}

    int inliers, outliers;
    int duplicates;    //!< of the right matches, this many are copies of others
    double noise;      //!< standard deviation of the points of the image in each coordinate, pixels
    bool onPlane;      //!< all object points on a plane, at most 50 degrees off the image; else at
                       //!< depths from 4 to 9
    double thickness;  //!< of that plane: standard deviation of the distances from it over its own
                       //!< distance
    double distortion;  //!< first radial coefficient
    /** OUTLIERS_UNIFORM: an object point with any point of the image. OUTLIERS_CLUSTERED: object
    points that are seen in one square of 80 pixels, with points of another one.
    OUTLIERS_SECOND_MODEL: right for another pose, in a square of 160 pixels, half as many as there
    are right ones at most; the others anywhere. */
    opencv_test::OutlierModel outlierModel;
    double scoreInformation;  //!< probability that a right match has a better score than a wrong
                              //!< one, below 1 or 1
    uint64 seed;
};

//! Object points and an image of 640 x 480 pixels, with the exact pose. Rows are in random order.
struct ViewScene
{
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> points;
    std::vector<float> scores;  //!< from 0 to 1, lower is better
    std::vector<uchar> truth;   //!< 1: a right match
    cv::Matx33d K, R;           //!< x ~ K (R X + t), up to distortion
    cv::Vec3d t;
    double distortion;

    int size() const { return (int)points.size(); }
};

ViewScene makeViewScene(const ViewOptions& options);

}  // namespace benchmark

#endif
