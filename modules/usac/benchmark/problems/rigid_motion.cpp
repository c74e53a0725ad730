// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rigid_motion.hpp"

#include "motion_files.hpp"
#include "opencv2/usac/geometry.hpp"
#include "squared_errors.hpp"
#include "view_files.hpp"

namespace benchmark {

namespace {

//! The threshold is the default of cv::estimateAffine3D. The number of iterations suffices for an
//! inlier ratio of 10 % (samples of three points).
const double THRESHOLD = 3;
const int MAX_ITERATIONS = 10000;

cv::Matx33d closestRotation(const cv::Matx33d& A)
{
    const cv::SVD svd(cv::Mat(A), cv::SVD::FULL_UV);
    const cv::Matx33d U(svd.u.ptr<double>()), Vt(svd.vt.ptr<double>());
    const double sign = cv::determinant(U) * cv::determinant(Vt) < 0 ? -1 : 1;
    return U * cv::Matx33d::diag(cv::Vec3d(1, 1, sign)) * Vt;
}

cv::Vec3d toVec(const cv::Point3f& point) { return cv::Vec3d(point.x, point.y, point.z); }

}  // namespace

RigidMotion::RigidMotion(bool scaled_)
    : MotionKind(scaled_ ? cv::usacv20::SIMILARITY_3D : cv::usacv20::RIGID_3D, scaled_ ? 'M' : 'R',
                 THRESHOLD, MAX_ITERATIONS),
      scaled(scaled_)
{}

void RigidMotion::read(const std::string& path, ImagePair& pair) const
{
    readSpacePoints(path + ".txt", pair);
    readScores(path + ".score", pair);
    readMotionTruth(TruthReader(path + ".json"), letter, scaled, pair);
}

double RigidMotion::modelError(const ImagePair& pair, const cv::Mat& model) const
{
    cv::Matx33d A;
    cv::Vec3d t;
    return toMotion(model, A, t) ? angleBetween(closestRotation(A), pair.R)
                                 : std::numeric_limits<double>::infinity();
}

double RigidMotion::modelCost(const ImagePair& pair, const cv::Mat& model, double threshold_) const
{
    cv::Matx33d A;
    cv::Vec3d t;
    if (!toMotion(model, A, t))
        return 1;
    return truncatedMean(pair.size(), threshold_, [&](int i) {
        const cv::Vec3d d = A * toVec(pair.objectPoints[i]) + t - toVec(pair.spacePoints2[i]);
        return d.dot(d);
    });
}

double RigidMotion::centerError(const ImagePair& pair, const cv::Mat& model) const
{
    cv::Matx33d A;
    cv::Vec3d t;
    if (!toMotion(model, A, t))
        return std::numeric_limits<double>::infinity();
    const cv::Matx33d difference = A - pair.scale * pair.R;
    const bool known = !pair.right.empty();
    const double error = rootOfMean(known ? (int)pair.right.size() : pair.size(), [&](int i) {
        const cv::Vec3d d = difference * toVec(pair.objectPoints[known ? pair.right[i] : i]) + t -
                            pair.t;
        return d.dot(d);
    });
    return 100 * error / pair.depth;
}

cv::Ptr<cv::usacv20::Usac> RigidMotion::estimator(const ImagePair& pair,
                                                  const cv::usacv20::Params& params) const
{
    return cv::usacv20::Usac::create(type, pair.objectPoints, pair.spacePoints2, params);
}

void RigidMotion::callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                             Estimate& estimate) const
{
    if (scaled)
        estimate.model = cv::usacv20::estimateSimilarity3D(pair.objectPoints, pair.spacePoints2,
                                                           params, estimate.mask);
    else
        estimate.model = cv::usacv20::estimateRigid3D(pair.objectPoints, pair.spacePoints2, params,
                                                      estimate.mask);
}

void RigidMotion::callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                             Estimate& estimate) const
{
    if (!cv::estimateAffine3D(pair.objectPoints, pair.spacePoints2, estimate.model, estimate.mask,
                              settings.threshold, settings.confidence))
        estimate = Estimate();
    else if (flag == AFFINE3D_REFIT)
        refit(pair, estimate);
}

void RigidMotion::refit(const ImagePair& pair, Estimate& estimate) const
{
    std::vector<cv::Point3f> points1, points2;
    for (int i = 0; i < pair.size(); ++i)
        if (estimate.mask.at<uchar>(i))
        {
            points1.push_back(pair.objectPoints[i]);
            points2.push_back(pair.spacePoints2[i]);
        }
    double scale = 1;
    estimate.model = cv::estimateAffine3D(points1, points2, scaled ? &scale : nullptr, true);
    if (!estimate.model.empty())
        estimate.model.colRange(0, 3) *= scale;
}

const ProblemKind& kindOfRigid3D()
{
    static const RigidMotion kind(false);
    return kind;
}

const ProblemKind& kindOfSimilarity3D()
{
    static const RigidMotion kind(true);
    return kind;
}

}  // namespace benchmark
