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

//! Size of both images in pixels.
const int SCENE_WIDTH = 640, SCENE_HEIGHT = 480;

//! Where the wrong matches are.
enum OutlierModel {
    OUTLIERS_UNIFORM,  //!< anywhere in both images
    OUTLIERS_LOCAL,    //!< a true match (H, affine maps: on the plane) displaced in image 2 by 5 to
                       //!< 50 pixels, with an error of at least 5 pixels
    OUTLIERS_MANY_TO_ONE,  //!< anywhere in image 1; in image 2 at the point of a true match; about
                           //!< ten wrong matches share each such point
    OUTLIERS_TARGETS,      //!< anywhere in image 1; in image 2 at one of two points, up to noise
    OUTLIERS_LINE,  //!< anywhere in image 1; in image 2, every second match is on one line, up to
                    //!< noise, and the others are anywhere
    OUTLIERS_CLUSTERED,     //!< in each image within one square of side 80 pixels
    OUTLIERS_SECOND_MODEL,  //!< true matches of another camera motion (H, affine maps: and of
                            //!< another plane), in image 1 within a square of side 160 pixels
    // With the following models, at most SceneOptions::structured wrong matches follow the model;
    // the others are uniform.
    OUTLIERS_SHIFT,  //!< shifted in image 2 by one common vector of 30 to 100 pixels, as for
                     //!< repeated windows of a facade
    OUTLIERS_PLANE,  //!< true matches of another camera motion and of another plane
    OUTLIERS_PLACE,  //!< in image 2 at one of `places` points, with Gaussian noise of 0.4 pixels,
                     //!< as from a watermark or a dead pixel
    OUTLIERS_CLUSTERS,  //!< each point in one of five squares of side 20 pixels of its image
    OUTLIERS_CENTER,    //!< both points with a Cauchy distribution about the center of their image;
                        //!< about half of the coordinates are within 20 pixels of the center
    OUTLIERS_WINDOW,    //!< in image 2 up to 60 pixels per coordinate from the position in image 1,
                        //!< as from a matcher with a search window
    OUTLIERS_BORDER     //!< both points anywhere on the border of their image
};

//! What the scores of a scene depend on; lower is better.
enum ScoreModel {
    SCORES_OF_TRUTH,   //!< whether the match is true, see scoreInformation
    SCORES_OF_SECOND,  //!< wrong matches of the second motion have the best scores; all other
                       //!< matches have worse, random scores
    SCORES_OF_PLACE,   //!< true matches in one square of side 160 pixels of image 1 have the best
                       //!< scores; all other matches have worse, random scores
    SCORES_NEAR        //!< distance in image 1 from the point of one true match
};

//! How the camera moves from image 1 to image 2.
enum Motion {
    MOTION_GENERAL,    //!< mostly sideways with a rotation; camera 2 is turned toward the scene
    MOTION_FORWARD,    //!< along the optical axis, with a rotation about a random axis
    MOTION_SIDEWAYS,   //!< parallel to the image plane, with a rotation about a random axis
    MOTION_RECTIFIED,  //!< along the image rows, without rotation
    MOTION_PLANAR,  //!< in a random horizontal direction, with a rotation about the vertical axis
    MOTION_CAR      //!< forward in a horizontal plane, in a direction turned by 1.5 times the angle
                    //!< of the rotation about the vertical axis
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
    int structured;  //!< OUTLIERS_SHIFT and later enumerators: maximum number of wrong matches that
                     //!< follow the model; the others are uniform
    int places;      //!< OUTLIERS_PLACE: number of points of image 2, 1 or 2
    double noise;    //!< standard deviation of the noise of each of the four coordinates in pixels
    uint64 seed;
    double planeFraction;      //!< F, E: fraction of the true matches on the plane; with other
                               //!< problems, all true matches are on it
    bool frontalPlane;         //!< the plane is parallel to image 1; otherwise it is tilted
    double nearest, farthest;  //!< depths of points off the plane; the plane has a depth of about 6
    int duplicates;            //!< number of true matches that are copies of other true matches
    int copies;  //!< number of times that each match occurs; `inliers` and `outliers` count
                 //!< different matches
    Motion motion;
    double angle;     //!< angle of the rotation in degrees; MOTION_GENERAL: before camera 2 is
                      //!< turned; MOTION_CAR: maximum; MOTION_RECTIFIED: not used
    double baseline;  //!< distance between the cameras, in the unit of the depths
    OutlierModel outlierModel;
    //! Probability that a true match has a better score than a wrong one, in (0, 1]. 0.5: the
    //! scores are not informative; 1: all true matches have better scores; near 0: all have worse
    //! scores.
    double scoreInformation;
    int second;  //!< OUTLIERS_UNIFORM: number of wrong matches that are nevertheless made as
                 //!< with OUTLIERS_SECOND_MODEL
    ScoreModel scoreModel;
};

/** @brief Points of space in two images of 640 x 480 pixels, with the exact model.

Rows are in random order. `clean1` and `clean2` are the points without noise; where `truth` is 0,
they equal the points unless the wrong matches have noise, too. With SCORES_OF_TRUTH, scores lie
between 0 and 1, lower is better: those of wrong matches are uniform, those of true matches are
1 - u^((1 - q) / q), where u is uniform and q is the option `scoreInformation`. With the same
options, H, F and E have the same cameras, and F and E also have the same points. Affinities and
similarities approximate this H at the middle of image 1, translations at a quarter of its width and
height. */
struct Scene
{
    cv::usacv20::ProblemType problem;
    std::vector<cv::Point2d> points1, points2, clean1, clean2;
    std::vector<float> scores;
    std::vector<uchar> truth;     //!< 1: a true match
    std::vector<uchar> onPlane;   //!< 1: a true match on the plane
    std::vector<uchar> onSecond;  //!< 1: a wrong match made as with OUTLIERS_SECOND_MODEL
    cv::Matx33d model;            //!< H, affine maps: last entry 1; F, E: unit Frobenius norm
    cv::Matx33d F;                //!< fundamental matrix of unit Frobenius norm, for all problems
    cv::Matx33d K, R;             //!< both cameras have the same K; X2 = R X1 + baseline * t
    cv::Vec3d t;                  //!< direction of the translation, of unit length

    int size() const { return (int)points1.size(); }
};

//! True for problems whose model maps points to points: all but F and E.
bool mapsPoints(cv::usacv20::ProblemType problem);

Scene makeScene(cv::usacv20::ProblemType problem, const SceneOptions& options = SceneOptions());
//! A scene with these numbers of matches, this seed and otherwise the default options.
Scene makeScene(cv::usacv20::ProblemType problem, int inliers, int outliers, uint64 seed = 1);

//! Scores of the matches of a scene, according to `options`.
std::vector<float> makeScores(const Scene& scene, const SceneOptions& options);
//! Scores for SCORES_OF_TRUTH; `information` is the option `scoreInformation`.
std::vector<float> makeScores(const std::vector<uchar>& truth, double information, uint64 seed);

//! Error of a match in pixels under a model of the scene's problem: transfer error in image 2 for
//! maps, Sampson distance for F and E.
double pixelError(const Scene& scene, const cv::Matx33d& model, const cv::Point2d& p1,
                  const cv::Point2d& p2);

//! A returned model as a 3x3 matrix; affine maps get the last row 0 0 1.
inline cv::Matx33d squareModel(const cv::Mat& model)
{
    cv::Matx33d M = cv::Matx33d::eye();
    std::copy(model.ptr<double>(), model.ptr<double>() + model.total(), M.val);
    return M;
}

const double DEGREE = CV_PI / 180;
//! Angle in radians of the rotation between a rotation matrix and the true one.
double angleBetween(const cv::Mat& R, const cv::Matx33d& truth);
//! Angle in radians between a unit vector and the true direction.
double angleBetween(const cv::Mat& t, const cv::Vec3d& truth);

//! Which true matches modelError() uses.
enum ScenePart { TRUE_MATCHES, ON_PLANE, OFF_PLANE };

//! Root mean square error in pixels of the true matches without noise. Infinite for an empty model,
//! one of a wrong size, or if `part` has no matches.
double modelError(const Scene& scene, const cv::Mat& model, ScenePart part = TRUE_MATCHES);

//! An estimator for the scene; E gets the camera matrix.
cv::Ptr<cv::usacv20::Usac> createUsac(const Scene& scene, const cv::usacv20::Params& params);

//! Runs an estimator for the scene once and returns its model.
cv::Mat estimate(const Scene& scene, const cv::usacv20::Params& params,
                 cv::OutputArray mask = cv::noArray(), cv::usacv20::Report* report = 0);
//! Runs an estimator like estimate(), but returns the report.
cv::usacv20::Report reportOf(const Scene& scene, const cv::usacv20::Params& params,
                             cv::OutputArray mask = cv::noArray());

//! Calls estimateRelativePose() for a scene of E whose lenses have no distortion.
bool relativePose(const Scene& scene, const cv::usacv20::Params& params, cv::Mat& R, cv::Mat& t,
                  cv::OutputArray mask, cv::usacv20::RelativePose& pose);

//! The model in the internal (normalized) coordinates of `points`, with unit Frobenius norm.
cv::Matx33d toInternal(const cv::usacv20::Correspondences& points, const cv::Matx33d& model);
//! The model scaled to unit Frobenius norm.
cv::Matx33d normalized(const cv::Matx33d& model);
//! The inverse of toInternal(), up to scale.
cv::Matx33d toInput(const cv::usacv20::Correspondences& points, const cv::Matx33d& model);

//! Norm of the difference of two models of unit Frobenius norm, up to sign.
double modelDistance(const cv::Matx33d& a, const cv::Matx33d& b);

}  // namespace opencv_test

#endif
