// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RIGID_SCENES_HPP
#define OPENCV_USACV20_TEST_RIGID_SCENES_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "problems/random_rotation.hpp"

namespace opencv_test {

//! Positions of the points of a RigidScene in space 1, near the origin before scaling and
//! translation.
enum RigidShape {
    RIGID_CLOUD,       //!< anywhere in a cube of side 2
    RIGID_PLANE,       //!< in a square of side 2 on a random plane
    RIGID_NEAR_PLANE,  //!< the same with Gaussian noise of 0.02 across the plane
    RIGID_LINE,        //!< on a segment of length 2
    RIGID_NEAR_LINE,   //!< the same with Gaussian noise of 0.02 in each coordinate
    RIGID_CLUSTER      //!< in one ball of radius 0.1
};

//! What the wrong matches are like. Lengths are those before scaling.
enum RigidOutliers {
    RIGID_OUTLIERS_UNIFORM,  //!< in space 1 like the true matches; in space 2 anywhere in a cube of
                             //!< side 4, whose center is the moved origin of space 1
    RIGID_OUTLIERS_CLUSTERED,      //!< in each space within one ball of radius 0.3
    RIGID_OUTLIERS_SECOND_MOTION,  //!< true matches of another motion, with the same noise
    RIGID_OUTLIERS_PLACE  //!< up to `structured` wrong matches have one of `places` points of
                          //!< space 2, with Gaussian noise of a quarter of the threshold; the
                          //!< others are uniform
};

//! What a synthetic scene of two spaces looks like. The unit of lengths other than the offsets is
//! `unit`.
struct RigidSceneOptions
{
    RigidSceneOptions()
        : size(200), inlierRatio(0.6), noise(0.01), seed(1), shape(RIGID_CLOUD),
          outliers(RIGID_OUTLIERS_UNIFORM), copies(1), scoreInformation(0.5), modelScale(1),
          unit(1), offset1(0, 0, 0), offset2(0, 0, 0), structured(0), places(1)
    {}

    int size;            //!< number of different matches, at least 4
    double inlierRatio;  //!< fraction of the matches that are true; at least 3 matches are true
    double noise;  //!< standard deviation of the noise of each coordinate of space 2, divided by
                   //!< `modelScale`
    uint64 seed;
    RigidShape shape;
    RigidOutliers outliers;
    int copies;  //!< number of times that each match occurs
    //! Probability that a true match has a better score than a wrong one, in (0, 1]. 0.5: the
    //! scores are not informative; 1: all true matches have better scores; near 0: all have worse
    //! scores.
    double scoreInformation;
    double modelScale;           //!< scale of the motion; 1: a rigid motion
    double unit;                 //!< factor of all coordinates before the offsets are added
    cv::Vec3d offset1, offset2;  //!< translations of both spaces after scaling
    int structured,
        places;  //!< RIGID_OUTLIERS_PLACE: maximum number of wrong matches that share a few
                 //!< points of space 2, and number of these points
};

/** @brief Points of two spaces, with the exact motion between them.

Rows are in random order. Scores lie between 0 and 1, lower is better: those of wrong matches are
uniform, those of true matches are 1 - u^((1 - q) / q), where u is uniform and q is the option
`scoreInformation`. */
struct RigidScene
{
    std::vector<cv::Point3d> points1, points2,
        clean2;  //!< clean2: points2 without noise; equal to points2 where `truth` is 0
    std::vector<float> scores;
    std::vector<uchar> truth;  //!< 1: a true match
    cv::Matx34d motion;        //!< [sR | t]: point of space 2 = s R * point of space 1 + t
    cv::Matx34d secondMotion;  //!< motion of the wrong matches of RIGID_OUTLIERS_SECOND_MOTION
    double unit;       //!< unit of space 2: the product of the options `unit` and `modelScale`
    double threshold;  //!< 3.5 standard deviations of the noise; without noise, 0.035 `unit`

    int size() const { return (int)points1.size(); }
};

RigidScene makeRigidScene(const RigidSceneOptions& options = RigidSceneOptions());

//! The point of space 2 to which a motion maps a point of space 1.
cv::Vec3d moved(const cv::Matx34d& motion, const cv::Point3d& point);

//! Distances in space 2 between the mapped points of space 1 and their counterparts.
std::vector<double> distancesOf(const RigidScene& scene, const cv::Matx34d& motion);

//! Angle in degrees between the rotation of a motion and the true one.
double rotationError(const RigidScene& scene, const cv::Matx34d& motion);

//! Root mean square distance in space 2, over the true matches, between the points to which
//! `motion` and the true motion map the same point, divided by RigidScene::unit.
double motionError(const RigidScene& scene, const cv::Matx34d& motion);

//! The matrix [scale * R, t].
cv::Matx34d motionFrom(double scale, const cv::Matx33d& R, const cv::Vec3d& t);

}  // namespace opencv_test

#endif
