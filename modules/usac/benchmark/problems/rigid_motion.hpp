// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_RIGID_MOTION_HPP
#define OPENCV_USACV20_BENCHMARK_RIGID_MOTION_HPP

#include "motion_kind.hpp"

namespace benchmark {

/** Problem 'R': the rigid motion [R | t] that maps points of space 1 to points of space 2. Problem
'M': the same with a scale s, [s R | t].

The rotation of an estimated affine map is the rotation closest to its 3x3 part. centerError() is
the root mean square distance between the right points of space 1 moved by the estimated and by the
true motion, in percent of the size of the scene (ImagePair::depth); all points are used if it is
unknown which are right. calib3d has no robust estimator for these problems; the functions of Rival
are the most similar ones. */
class RigidMotion : public MotionKind
{
public:
    /** AFFINE3D: `cv::estimateAffine3D(points1, points2, model, mask, threshold, confidence)`,
    RANSAC for an affine map of space with at most 1000 samples of four points. AFFINE3D_REFIT: the
    same, followed by a least-squares fit of a rigid motion (M: with a scale) to the inliers by the
    overload without a threshold. */
    enum Rival { AFFINE3D = 1000, AFFINE3D_REFIT };

    explicit RigidMotion(bool scaled);

    void read(const std::string& path, ImagePair& pair) const CV_OVERRIDE;
    double modelError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;
    double modelCost(const ImagePair& pair, const cv::Mat& model,
                     double threshold) const CV_OVERRIDE;
    double centerError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;

    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                         const cv::usacv20::Params& params) const CV_OVERRIDE;
    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE;
    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE;

private:
    void refit(const ImagePair& pair, Estimate& estimate) const;

    const bool scaled;
};

}  // namespace benchmark

#endif
