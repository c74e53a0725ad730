// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_POSE_SCENES_HPP
#define OPENCV_USACV20_TEST_POSE_SCENES_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace opencv_test {

//! Size of the image in pixels.
const int POSE_WIDTH = 640, POSE_HEIGHT = 480;

//! Positions of the object points of a PoseScene. All visible points have depths of about 4 to 9.
enum PoseShape {
    POSE_CLOUD,       //!< anywhere in the field of view
    POSE_PLANE,       //!< on one plane, tilted against the image by up to 30 degrees
    POSE_NEAR_PLANE,  //!< the same with Gaussian noise of 0.02 along the rays
    POSE_TWO_PLANES,  //!< alternately on two planes that are at least 20 degrees apart
    POSE_LINE,        //!< on one line, at least 200 pixels long, not parallel to the image
    POSE_NEAR_LINE,   //!< the same with Gaussian noise of 0.02 in each coordinate
    POSE_CLUSTER      //!< in one ball of radius 0.1, about 20 pixels across
};

//! What the wrong matches are like.
enum PoseOutliers {
    POSE_OUTLIERS_UNIFORM,      //!< object points like the true ones, image points anywhere
    POSE_OUTLIERS_CLUSTERED,    //!< object points in one ball of radius 0.5, image points in one
                                //!< square of side 80 pixels
    POSE_OUTLIERS_SECOND_POSE,  //!< true matches of another pose of the same object, with the same
                                //!< noise
    POSE_OUTLIERS_PLACE  //!< up to `structured` wrong matches have one of `places` image points,
                         //!< with Gaussian noise of 0.4 pixels; the others are uniform
};

//! What a synthetic scene for absolute poses looks like.
struct PoseSceneOptions
{
    PoseSceneOptions()
        : size(200), inlierRatio(0.7), noise(0.5), seed(1), shape(POSE_CLOUD), coefficients(0),
          outliers(POSE_OUTLIERS_UNIFORM), behind(0), atCenter(0), copies(1), scoreInformation(0.5),
          scale(1), offset(0, 0, 0), structured(0), places(1)
    {}

    int size;            //!< number of different matches, at least 4
    double inlierRatio;  //!< fraction of the matches that are true; at least 3 matches are true
    double noise;        //!< standard deviation of the noise of each image coordinate in pixels
    uint64 seed;
    PoseShape shape;
    int coefficients;  //!< number of distortion coefficients: 0, 4, 5, 8, 12 or 14
    PoseOutliers outliers;
    int behind;    //!< number of wrong matches made like true ones, but with the object points
                   //!< mirrored at the camera center, behind the camera
    int atCenter;  //!< number of wrong matches with object points at the camera center and image
                   //!< points anywhere
    int copies;    //!< number of times that each match occurs
    //! Probability that a true match has a better score than a wrong one, in (0, 1]. 0.5: the
    //! scores are not informative; 1: all true matches have better scores; near 0: all have worse
    //! scores.
    double scoreInformation;
    double scale;      //!< factor by which all lengths of the object are multiplied
    cv::Vec3d offset;  //!< translation of the object points after scaling
    int structured,
        places;  //!< POSE_OUTLIERS_PLACE: maximum number of wrong matches that share a few image
                 //!< points, and number of these image points
};

/** @brief Object points and their images, with the exact pose.

Rows are in random order. Scores lie between 0 and 1, lower is better: those of wrong matches are
uniform, those of true matches are 1 - u^((1 - q) / q), where u is uniform and q is the option
`scoreInformation`. */
struct PoseScene
{
    std::vector<cv::Point3d> object;
    std::vector<cv::Point2d> image, clean;  //!< with and without noise; equal where `truth` is 0
    std::vector<float> scores;
    std::vector<uchar> truth;  //!< 1: a true match
    cv::Matx33d K;
    std::vector<double> distortion;  //!< coefficients in OpenCV's order
    cv::Matx34d pose;                //!< [R t]: camera point = R * object point + t
    cv::Matx34d secondPose;          //!< pose of the wrong matches of POSE_OUTLIERS_SECOND_POSE
    double depth;  //!< depth of the middle of the object, in the unit of the object points

    int size() const { return (int)object.size(); }
};

PoseScene makePoseScene(const PoseSceneOptions& options = PoseSceneOptions());

//! Images of object points by cv::projectPoints. Points behind the camera are projected like those
//! in front of it.
std::vector<cv::Point2d> project(const PoseScene& scene, const cv::Matx34d& pose,
                                 const std::vector<cv::Point3d>& object);

//! Reprojection errors in pixels, with distortion; infinite for a point that is not in front of the
//! camera.
std::vector<double> pixelErrors(const PoseScene& scene, const cv::Matx34d& pose);

//! Angle in degrees between the rotation of a pose and the true one.
double rotationError(const PoseScene& scene, const cv::Matx34d& pose);

//! Distance between the camera center of a pose and the true one, divided by the depth of the
//! scene.
double centerError(const PoseScene& scene, const cv::Matx34d& pose);

}  // namespace opencv_test

#endif
