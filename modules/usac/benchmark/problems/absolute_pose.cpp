// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "motion_kind.hpp"

#include "opencv2/usac/geometry.hpp"
#include "squared_errors.hpp"
#include "view_files.hpp"

namespace benchmark {

namespace {

//! Problem P: the pose [R | t] of a camera from object points X and their images, which are at
//! K (R X + t) apart from the lens distortion.
//! centerError() is the distance between the estimated and the true camera center, in percent of
//! the median depth of the scene (ImagePair::depth).
class AbsolutePose : public MotionKind
{
public:
    AbsolutePose() : MotionKind(cv::usacv20::ABSOLUTE_POSE, 'P', 4, 1000) {}

    bool hasCamera2() const CV_OVERRIDE { return true; }
    void read(const std::string& path, ImagePair& pair) const CV_OVERRIDE
    {
        readObjectPoints(path + ".txt", pair);
        readScores(path + ".score", pair);
        readViewTruth(TruthReader(path + ".json"), letter, pair);
    }

    double modelError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE
    {
        cv::Matx33d R;
        cv::Vec3d t;
        return toMotion(model, R, t) ? angleBetween(R, pair.R)
                                     : std::numeric_limits<double>::infinity();
    }

    double modelCost(const ImagePair& pair, const cv::Mat& model,
                     double threshold_) const CV_OVERRIDE
    {
        cv::Matx33d R;
        cv::Vec3d t;
        if (!toMotion(model, R, t))
            return 1;
        const std::vector<cv::Point3d> points(pair.objectPoints.begin(), pair.objectPoints.end());
        std::vector<cv::Point2d> images;
        cv::Vec3d rotation;
        cv::Rodrigues(R, rotation);
        cv::projectPoints(points, rotation, t, pair.K2, pair.distortion, images);
        return truncatedMean(pair.size(), threshold_, [&](int i) {
            const cv::Point2d d = images[i] - cv::Point2d(pair.points2[i]);
            const bool inFront = R(2, 0) * points[i].x + R(2, 1) * points[i].y +
                                     R(2, 2) * points[i].z + t[2] >
                                 0;
            return inFront ? d.dot(d) : std::numeric_limits<double>::infinity();
        });
    }

    double centerError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE
    {
        cv::Matx33d R;
        cv::Vec3d t;
        if (!toMotion(model, R, t))
            return std::numeric_limits<double>::infinity();
        return 100 * cv::norm(R.t() * t - pair.R.t() * pair.t) / pair.depth;
    }

    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                         const cv::usacv20::Params& params) const CV_OVERRIDE
    {
        return cv::usacv20::Usac::create(type, pair.objectPoints, pair.points2, params, pair.K2,
                                         cv::noArray(), pair.distortion);
    }

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::usacv20::estimateAbsolutePose(pair.objectPoints, pair.points2, pair.K2,
                                                           pair.distortion, params, estimate.mask);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        cv::Mat rotation, translation;
        std::vector<int> inliers;
        if (!cv::solvePnPRansac(pair.objectPoints, pair.points2, pair.K2, pair.distortion, rotation,
                                translation, false, settings.maxIterations,
                                (float)settings.threshold, settings.confidence, inliers, flag))
            return;
        cv::Mat R;
        cv::Rodrigues(rotation, R);
        cv::hconcat(R, translation, estimate.model);
        estimate.mask = cv::Mat::zeros(pair.size(), 1, CV_8U);
        for (int inlier : inliers)
            estimate.mask.at<uchar>(inlier) = 1;
    }
};

}  // namespace

const ProblemKind& kindOfAbsolutePose()
{
    static const AbsolutePose kind;
    return kind;
}

}  // namespace benchmark
