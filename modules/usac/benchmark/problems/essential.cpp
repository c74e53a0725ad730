// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "epipolar.hpp"

#include "opencv2/usac/geometry.hpp"
#include "opencv2/imgproc.hpp"

namespace benchmark {

namespace {

const int ITERATIONS_OF_TWO_CAMERAS = 1000;

//! The parameters that calib3d derives from a USAC flag for E, as far as cv::UsacParams has them.
cv::UsacParams usacParamsOf(int flag, const Settings& settings)
{
    cv::UsacParams params;
    params.threshold = settings.threshold;
    params.confidence = settings.confidence;
    params.maxIterations = settings.maxIterations;
    params.sampler = flag == cv::USAC_PROSAC ? cv::SAMPLING_PROSAC : cv::SAMPLING_UNIFORM;
    params.score = flag == cv::USAC_MAGSAC ? cv::SCORE_METHOD_MAGSAC : cv::SCORE_METHOD_MSAC;
    params.isParallel = flag == cv::USAC_PARALLEL;
    params.loSampleSize = flag == cv::USAC_MAGSAC ? 50 : flag == cv::USAC_ACCURATE ? 20 : 16;
    params.loIterations = flag == cv::USAC_MAGSAC     ? 10
                          : flag == cv::USAC_ACCURATE ? 25
                          : flag == cv::USAC_FAST     ? 5
                                                      : 15;
    params.loMethod = flag == cv::USAC_MAGSAC     ? cv::LOCAL_OPTIM_SIGMA
                      : flag == cv::USAC_ACCURATE ? cv::LOCAL_OPTIM_GC
                      : flag == cv::USAC_DEFAULT || flag == cv::USAC_FAST
                          ? cv::LOCAL_OPTIM_INNER_AND_ITER_LO
                          : cv::LOCAL_OPTIM_INNER_LO;
    return params;
}

//! Converts pixels of a camera with the matrix K to pixels of a camera with the matrix `mean`.
cv::Mat toCamera(const std::vector<cv::Point2f>& points, const cv::Matx33d& K,
                 const cv::Matx33d& mean)
{
    cv::Mat result;
    cv::undistortPoints(points, result, K, cv::noArray(), cv::noArray(), mean);
    return result;
}

//! Problem E: the essential matrix; the pair must have both camera matrices.
class Essential : public Epipolar
{
public:
    Essential() : Epipolar(cv::usacv20::ESSENTIAL, 'E', cv::Size(3, 3), 1, 1000) {}

    bool hasCamera1() const CV_OVERRIDE { return true; }
    bool hasCamera2() const CV_OVERRIDE { return true; }
    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                         const cv::usacv20::Params& params) const CV_OVERRIDE
    {
        return cv::usacv20::Usac::create(type, pair.points1, pair.points2, params, pair.K1,
                                         pair.K2);
    }

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::findEssentialMat(pair.points1, pair.points2, pair.K1, pair.K2,
                                              cv::noArray(), cv::noArray(), estimate.mask, params);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        const cv::Mat none;
        if (settings.maxIterations == ITERATIONS_OF_TWO_CAMERAS)
            estimate.model = cv::findEssentialMat(pair.points1, pair.points2, pair.K1, none,
                                                  pair.K2, none, flag, settings.confidence,
                                                  settings.threshold, estimate.mask);
        else if (flag == cv::RANSAC || flag == cv::LMEDS)
        {
            const cv::Matx33d mean = (pair.K1 + pair.K2) * 0.5;
            estimate.model = cv::findEssentialMat(toCamera(pair.points1, pair.K1, mean),
                                                  toCamera(pair.points2, pair.K2, mean), mean, flag,
                                                  settings.confidence, settings.threshold,
                                                  settings.maxIterations, estimate.mask);
        }
        else
            estimate.model = cv::findEssentialMat(pair.points1, pair.points2, pair.K1, pair.K2,
                                                  none, none, estimate.mask,
                                                  usacParamsOf(flag, settings));
    }

protected:
    void checkTruth(const TruthReader& in, const ImagePair& pair) const CV_OVERRIDE
    {
        in.require(pair.hasCamera1, "K1", "needed for E");
        in.require(pair.hasCamera2, "K2", "needed for E");
    }

    cv::Matx33d toFundamental(const ImagePair& pair, const cv::Matx33d& model) const CV_OVERRIDE
    {
        return pair.K2.inv().t() * model * pair.K1.inv();
    }

    cv::Matx33d toEssential(const ImagePair&, const cv::Matx33d& model) const CV_OVERRIDE
    {
        return model;
    }
};

}  // namespace

const ProblemKind& kindOfEssential()
{
    static const Essential kind;
    return kind;
}

}  // namespace benchmark
