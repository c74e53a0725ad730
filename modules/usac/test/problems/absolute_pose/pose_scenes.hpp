// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_SCENES_HPP
#define OPENCV_USACV20_TEST_POSE_SCENES_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace opencv_test {

//! Size of the image, pixels.
enum { POSE_WIDTH = 640, POSE_HEIGHT = 480 };

//! Where the object points of a PoseScene are; all that the camera sees have depths of about 4 to
//! 9.
enum PoseShape {
    POSE_CLOUD,       //!< anywhere in the field of view
    POSE_PLANE,       //!< on one plane, tilted against the image by up to 30 degrees
    POSE_NEAR_PLANE,  //!< the same, but for normal noise of 0.02 along the rays
    POSE_TWO_PLANES,  //!< on two planes in turn, 20 degrees apart or more
    POSE_LINE,        //!< on one line, at least 200 pixels long, not parallel to the image
    POSE_NEAR_LINE,   //!< the same, but for normal noise of 0.02 in each coordinate
    POSE_CLUSTER      //!< in one ball of radius 0.1, about 20 pixels across
};

//! What the wrong matches are like.
enum PoseOutliers {
    POSE_OUTLIERS_UNIFORM,      //!< object points as the true ones, image points anywhere
    POSE_OUTLIERS_CLUSTERED,    //!< from one ball of radius 0.5 to one square of 80 pixels
    POSE_OUTLIERS_SECOND_POSE,  //!< true matches of another pose of the same object, with the same
                                //!< noise
    POSE_OUTLIERS_PLACE  //!< `structured` of them at one place of the image, but for 0.4 pixels;
                         //!< the others uniform
};

//! What a synthetic scene of absolute pose looks like.
struct PoseSceneOptions
{
    PoseSceneOptions()
        : size(200), inlierRatio(0.7), noise(0.5), seed(1), shape(POSE_CLOUD), coefficients(0),
          outliers(POSE_OUTLIERS_UNIFORM), behind(0), atCenter(0), copies(1), scoreInformation(0.5),
          scale(1), offset(0, 0, 0), structured(0), places(1)
    {}

    int size;            //!< different matches, >= 4
    double inlierRatio;  //!< part of them that is true; at least 3 are
    double noise;        //!< standard deviation in both image coordinates, pixels
    uint64 seed;
    PoseShape shape;
    int coefficients;  //!< of the distortion: 0, 4, 5, 8, 12 or 14
    PoseOutliers outliers;
    int behind;  //!< so many of the wrong matches are exact but for their object points, which are
                 //!< behind the camera
    int atCenter;  //!< of so many more the object points are at the center of the camera, the image
                   //!< points anywhere
    int copies;    //!< each match is there so many times
    //! Probability that a true match has a better score than a wrong one: 0.5: scores tell nothing,
    //! 1: all, near 0: upside down.
    double scoreInformation;
    double scale;      //!< all lengths of the object are multiplied by that,
    cv::Vec3d offset;  //!< and then its points moved by this
    int structured,
        places;  //!< POSE_OUTLIERS_PLACE: so many wrong matches, at so many places in turn
};

/** @brief Object points and their images, with the exact pose.

Rows are in random order. Scores lie between 0 and 1, lower is better: those of wrong matches are
uniform, those of true matches are 1 - u^((1 - q) / q) with u uniform and q the option
`scoreInformation`. */
struct PoseScene
{
    std::vector<cv::Point3d> object;
    std::vector<cv::Point2d> image, clean;  //!< with and without noise; where `truth` is 0 the same
    std::vector<float> scores;
    std::vector<uchar> truth;  //!< 1: a true match
    cv::Matx33d K;
    std::vector<double> distortion;  //!< in OpenCV's order
    cv::Matx34d pose;                //!< [R t]: camera point = R * object point + t
    cv::Matx34d secondPose;          //!< of POSE_OUTLIERS_SECOND_POSE
    double depth;                    //!< of the middle of the object, in its units

    int size() const { return (int)object.size(); }
};

PoseScene makePoseScene(const PoseSceneOptions& options = PoseSceneOptions());

//! Images of object points as cv::projectPoints has them. Points behind the camera are not told
//! from others.
std::vector<cv::Point2d> project(const PoseScene& scene, const cv::Matx34d& pose,
                                 const std::vector<cv::Point3d>& object);

//! Distances in pixels of the image points from those of a pose, distortion included; infinite for
//! a point that is not in front of the camera.
std::vector<double> pixelErrors(const PoseScene& scene, const cv::Matx34d& pose);

//! Angle between the rotations of a pose and of the true one, degrees.
double rotationError(const PoseScene& scene, const cv::Matx34d& pose);

//! Distance between the centers of the cameras over the depth of the scene.
double centerError(const PoseScene& scene, const cv::Matx34d& pose);

}  // namespace opencv_test

#endif
