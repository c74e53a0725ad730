// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SPACE_SCENE_HPP
#define OPENCV_USACV20_BENCHMARK_SPACE_SCENE_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! A synthetic cloud of points before and after a rigid motion of space.
struct SpaceOptions
{
    SpaceOptions()
        : inliers(200), outliers(100), duplicates(0), noise(0.5), scaled(false), flat(false),
          thickness(0), outlierModel(opencv_test::OUTLIERS_UNIFORM), scoreInformation(0.5), seed(1)
    {}

    int inliers, outliers;
    int duplicates;  //!< of the right matches, this many are copies of others
    double noise;    //!< standard deviation of the points of space 2 in each coordinate; that cloud
                     //!< is 200 wide times the scale
    bool scaled;     //!< the motion has a scale between 1/2 and 2; else 1
    bool flat;       //!< all points of space 1 on a plane; else they fill a cube
    double thickness;  //!< of that plane: standard deviation of the distances from it over the
                       //!< width of the cloud
    /** OUTLIERS_UNIFORM: a point of the cloud with any point of the cube around the moved cloud.
    OUTLIERS_CLUSTERED: from a cube of an eighth of the width to another one. OUTLIERS_SECOND_MODEL:
    right for another motion, in a cube of a quarter of the width, half as many as there are right
    ones at most; the others anywhere. */
    opencv_test::OutlierModel outlierModel;
    double scoreInformation;  //!< probability that a right match has a better score than a wrong
                              //!< one, below 1 or 1
    uint64 seed;
};

//! Two clouds with the exact motion. Rows are in random order.
struct SpaceScene
{
    std::vector<cv::Point3d> points1, points2;
    std::vector<float> scores;  //!< from 0 to 1, lower is better
    std::vector<uchar> truth;   //!< 1: a right match
    double scale;
    cv::Matx33d R;  //!< X2 = scale R X1 + t
    cv::Vec3d t;

    int size() const { return (int)points1.size(); }
};

SpaceScene makeSpaceScene(const SpaceOptions& options);

}  // namespace benchmark

#endif
