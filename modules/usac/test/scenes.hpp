// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SCENES_HPP
#define OPENCV_USACV20_TEST_SCENES_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac.hpp"

namespace opencv_test {

//! Size of both images.
enum { SCENE_WIDTH = 640, SCENE_HEIGHT = 480 };

//! Where the wrong matches are.
enum OutlierModel
{
    OUTLIERS_UNIFORM,     //!< anywhere in both images
    OUTLIERS_LOCAL,       //!< a true match (H: on the plane), displaced in image 2 by 5 to 50 pixels, at least 5 off the model
    OUTLIERS_MANY_TO_ONE  //!< in image 2 the point of a true match, about ten with the same; anywhere in image 1
};

//! What a synthetic scene looks like.
struct SceneOptions
{
    SceneOptions()
        : inliers(200), outliers(100), noise(0.5), seed(1), planeFraction(0), duplicates(0), angle(12),
          outlierModel(OUTLIERS_UNIFORM), scoreInformation(0.5) {}

    //! Sets `inliers` and `outliers`.
    void setSize(int size, double inlierRatio);

    int inliers;              //!< true matches
    int outliers;             //!< wrong matches
    double noise;             //!< standard deviation in each of the four coordinates, pixels
    uint64 seed;
    double planeFraction;     //!< F, E: this part of the true matches lies on one plane; H: all do
    int duplicates;           //!< of the true matches, this many are copies of others
    double angle;             //!< rotation between the cameras, degrees
    OutlierModel outlierModel;
    //! Probability that a true match has a better score than a wrong one: 0.5: scores tell nothing, 1: all.
    double scoreInformation;
};

/** @brief Two images of 640 x 480 pixels of points in space, with the exact model.

Rows are in random order. `clean1` and `clean2` are the points without noise; where `truth` is 0 they are as `points`.
Scores lie between 0 and 1, lower is better: those of wrong matches are uniform, those of true matches are 1 - u^((1 - q) / q)
with u uniform and q the option `scoreInformation`. H, F and E have the same cameras, F and E also the same points. */
struct Scene
{
    cv::usacv20::ProblemType problem;
    std::vector<cv::Point2d> points1, points2, clean1, clean2;
    std::vector<float> scores;
    std::vector<uchar> truth;    //!< 1: a true match
    std::vector<uchar> onPlane;  //!< 1: a true match on the plane
    cv::Matx33d model;           //!< H with h33 = 1, F or E of unit Frobenius norm
    cv::Matx33d F;               //!< of unit Frobenius norm, for all problems
    cv::Matx33d K, R;            //!< both cameras have the same K; X2 = R X1 + t
    cv::Vec3d t;                 //!< of unit length

    int size() const { return (int)points1.size(); }
};

Scene makeScene(cv::usacv20::ProblemType problem, const SceneOptions& options = SceneOptions());

//! Distance in pixels of a match under a model of the scene's problem: transfer distance in image 2, or Sampson's.
double pixelError(const Scene& scene, const cv::Matx33d& model, const cv::Point2d& p1, const cv::Point2d& p2);

//! What part of the rows, as the caller selects them.
enum ScenePart { TRUE_MATCHES, ON_PLANE, OFF_PLANE };

//! Root mean square of the errors of the true matches without noise; infinite for an empty or wrong model.
double modelError(const Scene& scene, const cv::Mat& model, ScenePart part = TRUE_MATCHES);

//! An estimator of the scene; E gets the camera matrix.
cv::Ptr<cv::usacv20::Usac> createUsac(const Scene& scene, const cv::usacv20::Params& params);

//! One estimation.
cv::Mat estimate(const Scene& scene, const cv::usacv20::Params& params, cv::OutputArray mask = cv::noArray(),
                 cv::usacv20::Report* report = 0);

//! The model in the coordinates of `points`, of unit Frobenius norm.
cv::Matx33d toInternal(const cv::usacv20::Correspondences& points, const cv::Matx33d& model);

//! Norm of the difference of two models of unit Frobenius norm, up to sign.
double modelDistance(const cv::Matx33d& a, const cv::Matx33d& b);

//! Points of our own as Correspondences; they live as long as this object.
class OwnPoints
{
public:
    OwnPoints(cv::usacv20::ProblemType problem, const std::vector<cv::Point2d>& points1,
              const std::vector<cv::Point2d>& points2, double inlierThreshold = 1);

    const cv::usacv20::Correspondences& view() const { return points; }

private:
    cv::usacv20::Correspondences points;
    std::vector<double> doubles[4];
    cv::Mat floats;
    std::vector<int> index;

    OwnPoints(const OwnPoints&);
    OwnPoints& operator=(const OwnPoints&);
};

} // namespace opencv_test

#endif
