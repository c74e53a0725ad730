// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SPACE_SCENE_HPP
#define OPENCV_USACV20_BENCHMARK_SPACE_SCENE_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Options of a synthetic cloud of 3D points before (space 1) and after (space 2) a motion: a
//! rotation, a translation and, if `scaled`, a scale.
struct SpaceOptions
{
    SpaceOptions()
        : inliers(200), outliers(100), duplicates(0), noise(0.5), scaled(false), flat(false),
          thickness(0), outlierModel(opencv_test::OUTLIERS_UNIFORM), scoreInformation(0.5), seed(1)
    {}

    int inliers, outliers;  //!< numbers of right and of wrong matches
    int duplicates;         //!< number of right matches that are copies of other right matches
    double noise;      //!< standard deviation of the noise of each coordinate in space 2, where the
                       //!< width of the cloud is 200 * scale
    bool scaled;       //!< true: the scale is between 1/2 and 2; false: the scale is 1
    bool flat;         //!< true: points of space 1 on a plane; false: in a cube
    double thickness;  //!< if flat: standard deviation of the distances from the plane, as a
                       //!< fraction of the cloud's width
    /** The wrong matches. OUTLIERS_UNIFORM: each joins a point of the cloud and a random point of
    the cube around the moved cloud. OUTLIERS_CLUSTERED: all lead from one cube, whose side is an
    eighth of the cloud's width, to another such cube. OUTLIERS_SECOND_MODEL: points in a cube whose
    side is a quarter of the width follow another motion, at most half as many as there are right
    matches; the other wrong matches are uniform. */
    opencv_test::OutlierModel outlierModel;
    double scoreInformation;  //!< probability that a right match has a better score than a wrong
                              //!< one
    uint64 seed;
};

//! Two clouds of points and the exact motion. Matches are in random order.
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
