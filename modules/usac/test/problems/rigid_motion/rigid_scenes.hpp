// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_SCENES_HPP
#define OPENCV_USACV20_TEST_RIGID_SCENES_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "problems/random_rotation.hpp"

namespace opencv_test {

//! Where the points of a RigidScene are in space 1, about the origin before they are scaled and
//! moved.
enum RigidShape {
    RIGID_CLOUD,       //!< anywhere in a cube of side 2
    RIGID_PLANE,       //!< in a square of side 2 on any plane
    RIGID_NEAR_PLANE,  //!< the same, but for normal noise of 0.02 across it
    RIGID_LINE,        //!< on a segment of length 2
    RIGID_NEAR_LINE,   //!< the same, but for normal noise of 0.02 in each coordinate
    RIGID_CLUSTER      //!< in one ball of radius 0.1
};

//! What the wrong matches are like.
enum RigidOutliers {
    RIGID_OUTLIERS_UNIFORM,  //!< in space 1 as the true ones, in space 2 anywhere in a cube of side
                             //!< 4 around them
    RIGID_OUTLIERS_CLUSTERED,      //!< from one ball of radius 0.3 to another
    RIGID_OUTLIERS_SECOND_MOTION,  //!< true matches of another motion, with the same noise
    RIGID_OUTLIERS_PLACE  //!< `structured` of them in space 2 at one place, but for a quarter of
                          //!< the threshold; the others uniform
};

//! What a synthetic scene of two spaces looks like. Lengths are in units of `unit`.
struct RigidSceneOptions
{
    RigidSceneOptions()
        : size(200), inlierRatio(0.6), noise(0.01), seed(1), shape(RIGID_CLOUD),
          outliers(RIGID_OUTLIERS_UNIFORM), copies(1), scoreInformation(0.5), modelScale(1),
          unit(1), offset1(0, 0, 0), offset2(0, 0, 0), structured(0), places(1)
    {}

    int size;            //!< different matches, >= 4
    double inlierRatio;  //!< part of them that is true; at least 3 are
    double
        noise;  //!< standard deviation in each coordinate of space 2, times the scale of the model
    uint64 seed;
    RigidShape shape;
    RigidOutliers outliers;
    int copies;  //!< each match is there so many times
    //! Probability that a true match has a better score than a wrong one: 0.5: scores tell nothing,
    //! 1: all, near 0: upside down.
    double scoreInformation;
    double modelScale;           //!< of the motion; 1: a rigid one
    double unit;                 //!< all coordinates are multiplied by that,
    cv::Vec3d offset1, offset2;  //!< and then the points of each space moved by these
    int structured,
        places;  //!< RIGID_OUTLIERS_PLACE: so many wrong matches, at so many places in turn
};

/** @brief Points of two spaces, with the exact motion between them.

Rows are in random order. Scores lie between 0 and 1, lower is better: those of wrong matches are
uniform, those of true matches are 1 - u^((1 - q) / q) with u uniform and q the option
`scoreInformation`. */
struct RigidScene
{
    std::vector<cv::Point3d> points1, points2,
        clean2;  //!< clean2: without noise; where `truth` is 0 as points2
    std::vector<float> scores;
    std::vector<uchar> truth;  //!< 1: a true match
    cv::Matx34d motion;        //!< [s R t]: point of space 2 = s R point of space 1 + t
    cv::Matx34d secondMotion;  //!< of RIGID_OUTLIERS_SECOND_MOTION
    double unit;               //!< of space 2: the option `unit` times that of the model
    double
        threshold;  //!< that suits the noise: 3.5 standard deviations, 0.035 units if there is none

    int size() const { return (int)points1.size(); }
};

RigidScene makeRigidScene(const RigidSceneOptions& options = RigidSceneOptions());

//! What a motion makes of a point.
cv::Vec3d moved(const cv::Matx34d& motion, const cv::Point3d& point);

//! Distances in space 2 of the points from where a motion takes their counterparts.
std::vector<double> distancesOf(const RigidScene& scene, const cv::Matx34d& motion);

//! Angle between the rotations of a motion and of the true one, degrees.
double rotationError(const RigidScene& scene, const cv::Matx34d& motion);

//! Root mean square over the true matches of the distance between where the two take a point, in
//! units of the scene.
double motionError(const RigidScene& scene, const cv::Matx34d& motion);

//! [scale * R, t].
cv::Matx34d motionFrom(double scale, const cv::Matx33d& R, const cv::Vec3d& t);

}  // namespace opencv_test

#endif
