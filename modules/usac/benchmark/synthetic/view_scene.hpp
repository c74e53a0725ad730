// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_VIEW_SCENE_HPP
#define OPENCV_USACV20_BENCHMARK_VIEW_SCENE_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Options of a synthetic view of object points.
struct ViewOptions
{
    ViewOptions()
        : inliers(200), outliers(100), duplicates(0), noise(0.5), onPlane(false), thickness(0),
          distortion(0), outlierModel(opencv_test::OUTLIERS_UNIFORM), scoreInformation(0.5), seed(1)
    {}

    int inliers, outliers;  //!< numbers of right and of wrong matches
    int duplicates;         //!< number of right matches that are copies of other right matches
    double noise;           //!< standard deviation of the noise of each image coordinate, pixels;
                            //!< uniform wrong matches have no noise
    bool onPlane;       //!< true: object points on a plane, tilted by at most 50 degrees from the
                        //!< image plane; false: depths from 4 to 9
    double thickness;   //!< if on a plane: standard deviation of the distances from the plane, as a
                        //!< fraction of the plane's distance from the camera
    double distortion;  //!< first radial coefficient of the lens distortion
    /** The wrong matches. OUTLIERS_UNIFORM: each joins an object point and a random point of the
    image. OUTLIERS_CLUSTERED: each joins an object point whose true image is in a square of side 80
    pixels and a point of another such square. OUTLIERS_SECOND_MODEL: each joins an object point
    whose true image is in a square of side 160 pixels and its image under another pose; there are
    at most half as many of these as right matches, and the other wrong matches are uniform. Lens
    distortion is ignored for these squares. */
    opencv_test::OutlierModel outlierModel;
    double scoreInformation;  //!< probability that a right match has a better score than a wrong
                              //!< one
    uint64 seed;
};

//! Object points and an image of 640 x 480 pixels, with the exact pose. Matches are in random
//! order.
struct ViewScene
{
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> points;
    std::vector<float> scores;  //!< from 0 to 1, lower is better
    std::vector<uchar> truth;   //!< 1: a right match
    cv::Matx33d K, R;           //!< x ~ K (R X + t), apart from the distortion
    cv::Vec3d t;
    double distortion;

    int size() const { return (int)points.size(); }
};

ViewScene makeViewScene(const ViewOptions& options);

}  // namespace benchmark

#endif
