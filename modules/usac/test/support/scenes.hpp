// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SCENES_HPP
#define OPENCV_USACV20_TEST_SCENES_HPP

#include <algorithm>
#include <climits>
#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac.hpp"
#include "support/own_points.hpp"
#include "support/random_points.hpp"

namespace opencv_test {

//! Size of both images.
enum { SCENE_WIDTH = 640, SCENE_HEIGHT = 480 };

//! Where the wrong matches are.
enum OutlierModel {
    OUTLIERS_UNIFORM,  //!< anywhere in both images
    OUTLIERS_LOCAL,    //!< a true match (not F, E: on the plane), displaced in image 2 by 5 to 50
                       //!< pixels, at least 5 off the model
    OUTLIERS_MANY_TO_ONE,  //!< in image 2 the point of a true match, about ten with the same;
                           //!< anywhere in image 1
    OUTLIERS_TARGETS,      //!< in image 2 one of two points, but for noise; anywhere in image 1
    OUTLIERS_LINE,  //!< every second one on one line of image 2, but for noise, the others anywhere
    OUTLIERS_CLUSTERED,     //!< from one square of 80 pixels in image 1 to one in image 2
    OUTLIERS_SECOND_MODEL,  //!< true matches of another motion (not F, E: of another plane, too),
                            //!< from a square of 160 pixels in image 1
    // `structured` of the wrong matches are as follows, the others anywhere
    OUTLIERS_SHIFT,  //!< all shifted in image 2 by the same 30 to 100 pixels, as repeated windows
                     //!< are
    OUTLIERS_PLANE,  //!< on a plane that another motion of the camera has seen, from all of image 1
    OUTLIERS_PLACE,  //!< in image 2 at one place, but for 0.4 pixels, as a watermark or a dead
                     //!< pixel makes them
    OUTLIERS_CLUSTERS,  //!< each point in one of five squares of 20 pixels of its image
    OUTLIERS_CENTER,  //!< both points about the middle of their image: Cauchy's distribution, half
                      //!< within 20 pixels
    OUTLIERS_WINDOW,  //!< in image 2 up to 60 pixels from where they are in image 1, as a matcher's
                      //!< search window
    OUTLIERS_BORDER   //!< both points anywhere on the border of their image
};

//! What the scores of a scene tell.
enum ScoreModel {
    SCORES_OF_TRUTH,   //!< what is right, as far as SceneOptions::scoreInformation says
    SCORES_OF_SECOND,  //!< the matches of the second motion are the best, the others have random
                       //!< scores
    SCORES_OF_PLACE,   //!< the right matches in one square of 160 pixels of image 1 are the best,
                       //!< the others random
    SCORES_NEAR        //!< the nearer to one point of image 1, the better, right or wrong
};

//! How the camera moves from image 1 to image 2.
enum Motion {
    MOTION_GENERAL,    //!< mostly sideways, and a rotation; the camera turns to what it has seen
    MOTION_FORWARD,    //!< along the optical axis, and a rotation about any axis
    MOTION_SIDEWAYS,   //!< parallel to the image, and a rotation about any axis
    MOTION_RECTIFIED,  //!< along the rows, no rotation
    MOTION_PLANAR,     //!< anywhere in the horizontal plane, and a rotation about the vertical axis
    MOTION_CAR  //!< on a circle of the horizontal plane: forward by half the angle of the rotation
                //!< about the vertical axis
};

//! What a synthetic scene looks like.
struct SceneOptions
{
    SceneOptions()
        : inliers(200), outliers(100), structured(INT_MAX), places(1), noise(0.5), seed(1),
          planeFraction(0), frontalPlane(false), nearest(4), farthest(9), duplicates(0), copies(1),
          motion(MOTION_GENERAL), angle(12), baseline(1), outlierModel(OUTLIERS_UNIFORM),
          scoreInformation(0.5), second(0), scoreModel(SCORES_OF_TRUTH)
    {}

    //! Sets `inliers` and `outliers`.
    void setSize(int size, double inlierRatio);

    int inliers;     //!< true matches
    int outliers;    //!< wrong matches
    int structured;  //!< so many of them, at most, are as OUTLIERS_SHIFT and those behind it say;
                     //!< the others anywhere
    int places;      //!< OUTLIERS_PLACE: at so many places in turn, 1 or 2
    double noise;    //!< standard deviation in each of the four coordinates, pixels
    uint64 seed;
    double
        planeFraction;  //!< F, E: this part of the true matches lies on one plane; others: all do
    bool frontalPlane;  //!< the plane is parallel to image 1; else any plane in front of the camera
    double nearest, farthest;  //!< depths of the points off the plane; the plane is at 6
    int duplicates;            //!< of the true matches, this many are copies of others
    int copies;  //!< each match is there so many times; `inliers` and `outliers` are numbers of
                 //!< different ones
    Motion motion;
    double angle;     //!< rotation between the cameras, degrees
    double baseline;  //!< distance between the cameras
    OutlierModel outlierModel;
    //! Probability that a true match has a better score than a wrong one: 0.5: scores tell nothing,
    //! 1: all, near 0: upside down.
    double scoreInformation;
    int second;  //!< OUTLIERS_UNIFORM: of the wrong matches, this many are as of
                 //!< OUTLIERS_SECOND_MODEL
    ScoreModel scoreModel;
};

/** @brief Two images of 640 x 480 pixels of points in space, with the exact model.

Rows are in random order. `clean1` and `clean2` are the points without noise; where `truth` is 0
they are as `points`. Scores lie between 0 and 1, lower is better: those of wrong matches are
uniform, those of true matches are 1 - u^((1 - q) / q) with u uniform and q the option
`scoreInformation`. H, F and E have the same cameras, F and E also the same points. Affinities,
similarities and translations are those nearest to that H in the middle of image 1. */
struct Scene
{
    cv::usacv20::ProblemType problem;
    std::vector<cv::Point2d> points1, points2, clean1, clean2;
    std::vector<float> scores;
    std::vector<uchar> truth;     //!< 1: a true match
    std::vector<uchar> onPlane;   //!< 1: a true match on the plane
    std::vector<uchar> onSecond;  //!< 1: a wrong match of the second motion
    cv::Matx33d model;  //!< H, affinity, similarity with h33 = 1, F or E of unit Frobenius norm
    cv::Matx33d F;      //!< of unit Frobenius norm, for all problems
    cv::Matx33d K, R;   //!< both cameras have the same K; X2 = R X1 + t
    cv::Vec3d t;        //!< of unit length

    int size() const { return (int)points1.size(); }
};

//! Problems whose model maps points to points: all but F and E.
bool mapsPoints(cv::usacv20::ProblemType problem);

Scene makeScene(cv::usacv20::ProblemType problem, const SceneOptions& options = SceneOptions());

//! Scores of a scene as its options say.
std::vector<float> makeScores(const Scene& scene, const SceneOptions& options);
//! Scores of matches as of a Scene; `information` is the option `scoreInformation`.
std::vector<float> makeScores(const std::vector<uchar>& truth, double information, uint64 seed);

//! Distance in pixels of a match under a model of the scene's problem: transfer distance in image
//! 2, or Sampson's.
double pixelError(const Scene& scene, const cv::Matx33d& model, const cv::Point2d& p1,
                  const cv::Point2d& p2);

//! A model of the caller; an affinity or similarity gets the last row 0 0 1.
inline cv::Matx33d squareModel(const cv::Mat& model)
{
    cv::Matx33d M = cv::Matx33d::eye();
    std::copy(model.ptr<double>(), model.ptr<double>() + model.total(), M.val);
    return M;
}

//! What part of the rows, as the caller selects them.
enum ScenePart { TRUE_MATCHES, ON_PLANE, OFF_PLANE };

//! Root mean square of the errors of the true matches without noise; infinite for an empty or wrong
//! model.
double modelError(const Scene& scene, const cv::Mat& model, ScenePart part = TRUE_MATCHES);

//! An estimator of the scene; E gets the camera matrix.
cv::Ptr<cv::usacv20::Usac> createUsac(const Scene& scene, const cv::usacv20::Params& params);

//! One estimation.
cv::Mat estimate(const Scene& scene, const cv::usacv20::Params& params,
                 cv::OutputArray mask = cv::noArray(), cv::usacv20::Report* report = 0);

//! The model in the coordinates of `points`, of unit Frobenius norm.
cv::Matx33d toInternal(const cv::usacv20::Correspondences& points, const cv::Matx33d& model);
//! Of unit norm.
cv::Matx33d normalized(const cv::Matx33d& model);
//! The inverse of toInternal(), up to scale.
cv::Matx33d toInput(const cv::usacv20::Correspondences& points, const cv::Matx33d& model);

//! Norm of the difference of two models of unit Frobenius norm, up to sign.
double modelDistance(const cv::Matx33d& a, const cv::Matx33d& b);

}  // namespace opencv_test

#endif
