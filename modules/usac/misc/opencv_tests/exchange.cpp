// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "exchange.hpp"

#undef findHomography
#undef findFundamentalMat
#undef findEssentialMat
#undef estimateAffine2D
#undef estimateAffinePartial2D
#undef solvePnPRansac

namespace cv {

UsacV20Method Exchange::flag = USACV20;
int Exchange::calls = 0;

static UsacV20Method exchange()
{
    ++Exchange::calls;
    return Exchange::flag;
}

static usacv20::Params exchange(double threshold, double confidence, int maxIterations)
{
    usacv20::Params params = usacv20::Params::fromMethod(exchange());
    params.threshold = threshold;
    params.confidence = confidence;
    params.maxIterations = maxIterations;
    return params;
}

static usacv20::Params exchange(const UsacParams& params)
{
    return exchange(params.threshold, params.confidence, params.maxIterations);
}

// Six of the documented differences from OpenCV are undone in this file, so that the tests show
// only other differences.

static bool isUsac(int method) { return method >= USAC_DEFAULT && method <= USAC_MAGSAC; }

//! 1. cv::findFundamentalMat replaces a confidence outside (0, 1) with 0.99; this module raises an
//!    exception.
static double confidenceOf(double confidence)
{
    return confidence > 0 && confidence < 1 ? confidence : 0.99;
}

//! 2. This module returns F with unit norm; OpenCV's flags return F with f33 = 1.
static Mat scaled(const Mat& F)
{
    return F.empty() || F.at<double>(2, 2) == 0 ? F : Mat(F / F.at<double>(2, 2));
}

static usacv20::Params anySide(usacv20::Params params)
{
    params.degeneracy &= ~usacv20::DEGENERACY_ORIENTATION;
    return params;
}

/** 3. OpenCV's flags other than USAC_* do not check whether points are in front of both cameras.
   This module's flags do, and reject samples with points both in front of and behind the cameras.
   test_fundam.cpp has correct matches of points in front of and behind the cameras. Therefore, if
   not all points are inliers, the model is also estimated without the check. The second model is
   returned if all points are its inliers, or if the first estimate (in 11 of 1000 calls) has no
   model.

@param find, findAnywhere estimations with and without the check; their argument is the mask */
template <typename Find, typename FindAnywhere>
Mat maybeBehind(int method, OutputArray mask, const Find& find, const FindAnywhere& findAnywhere)
{
    Mat inFront, anywhere;
    const Mat model = find(inFront);
    const bool enough = isUsac(method) || (!model.empty() && countNonZero(inFront == 0) == 0);
    const Mat other = enough ? Mat() : findAnywhere(anywhere);
    const bool better = !other.empty() && (model.empty() || countNonZero(anywhere == 0) == 0);
    if (mask.needed())
        (better ? anywhere : inFront).copyTo(mask);
    return better ? other : model;
}

//! 4. For E, OpenCV's USAC flags compare the threshold with the symmetric distance to the epipolar
//!    lines instead of the Sampson distance.
static usacv20::Params symmetric(usacv20::Params params)
{
    params.residual = usacv20::RESIDUAL_SYMMETRIC;
    return params;
}

Mat exchangedHomography(InputArray points1, InputArray points2, int, double threshold,
                        OutputArray mask, int maxIters, double confidence)
{
    return findHomography(points1, points2, exchange(), threshold, mask, maxIters, confidence);
}

Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask, int,
                        double threshold)
{
    return findHomography(points1, points2, mask, exchange(), threshold);
}

Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask,
                        const UsacParams& params)
{
    return findHomography(points1, points2, mask, exchange(params));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int method, double threshold,
                            double confidence, int maxIters, OutputArray mask)
{
    confidence = confidenceOf(confidence);
    return scaled(maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, exchange(), threshold, confidence, maxIters,
                                      inliers);
        },
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, inliers,
                                      anySide(exchange(threshold, confidence, maxIters)));
        }));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int method, double threshold,
                            double confidence, OutputArray mask)
{
    confidence = confidenceOf(confidence);
    return scaled(maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, exchange(), threshold, confidence, inliers);
        },
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, inliers,
                                      anySide(exchange(threshold, confidence, 1000)));
        }));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, int method,
                            double threshold, double confidence)
{
    confidence = confidenceOf(confidence);
    return scaled(maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, inliers, exchange(), threshold, confidence);
        },
        [&](Mat& inliers) {
            return findFundamentalMat(points1, points2, inliers,
                                      anySide(exchange(threshold, confidence, 1000)));
        }));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                            const UsacParams& params)
{
    return scaled(findFundamentalMat(points1, points2, mask, exchange(params)));
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int method,
                          double confidence, double threshold, int maxIters, OutputArray mask)
{
    if (isUsac(method))
        return findEssentialMat(points1, points2, K, K, noArray(), noArray(), mask,
                                symmetric(exchange(threshold, confidence, maxIters)));
    return maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, exchange(), confidence, threshold,
                                    maxIters, inliers);
        },
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, K, noArray(), noArray(), inliers,
                                    anySide(exchange(threshold, confidence, maxIters)));
        });
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int method,
                          double confidence, double threshold, OutputArray mask)
{
    if (isUsac(method))
        return exchangedEssentialMat(points1, points2, K, method, confidence, threshold, 1000,
                                     mask);
    return maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, exchange(), confidence, threshold,
                                    inliers);
        },
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, K, noArray(), noArray(), inliers,
                                    anySide(exchange(threshold, confidence, 1000)));
        });
}

static Matx33d cameraOf(double focal, Point2d pp)
{
    return Matx33d(focal, 0, pp.x, 0, focal, pp.y, 0, 0, 1);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                          int method, double confidence, double threshold, int maxIters,
                          OutputArray mask)
{
    const Matx33d K = cameraOf(focal, pp);
    if (isUsac(method))
        return exchangedEssentialMat(points1, points2, K, method, confidence, threshold, maxIters,
                                     mask);
    return maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, focal, pp, exchange(), confidence, threshold,
                                    maxIters, inliers);
        },
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, K, noArray(), noArray(), inliers,
                                    anySide(exchange(threshold, confidence, maxIters)));
        });
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                          int method, double confidence, double threshold, OutputArray mask)
{
    const Matx33d K = cameraOf(focal, pp);
    if (isUsac(method))
        return exchangedEssentialMat(points1, points2, K, method, confidence, threshold, mask);
    return maybeBehind(
        method, mask,
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, focal, pp, exchange(), confidence, threshold,
                                    inliers);
        },
        [&](Mat& inliers) {
            return findEssentialMat(points1, points2, K, K, noArray(), noArray(), inliers,
                                    anySide(exchange(threshold, confidence, 1000)));
        });
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1,
                          InputArray distortion1, InputArray K2, InputArray distortion2, int method,
                          double confidence, double threshold, OutputArray mask)
{
    if (isUsac(method))
        return findEssentialMat(points1, points2, K1, K2, distortion1, distortion2, mask,
                                symmetric(exchange(threshold, confidence, 1000)));
    return findEssentialMat(points1, points2, K1, distortion1, K2, distortion2, exchange(),
                            confidence, threshold, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1, InputArray K2,
                          InputArray distortion1, InputArray distortion2, OutputArray mask,
                          const UsacParams& params)
{
    return findEssentialMat(points1, points2, K1, K2, distortion1, distortion2, mask,
                            symmetric(exchange(params)));
}

Mat exchangedAffine2D(InputArray from, InputArray to, OutputArray inliers, int, double threshold,
                      size_t maxIters, double confidence, size_t refineIters)
{
    return estimateAffine2D(from, to, inliers, exchange(), threshold, maxIters, confidence,
                            refineIters);
}

Mat exchangedAffine2D(InputArray from, InputArray to, OutputArray inliers, const UsacParams& params)
{
    return estimateAffine2D(from, to, inliers, exchange(params));
}

Mat exchangedAffinePartial2D(InputArray from, InputArray to, OutputArray inliers, int,
                             double threshold, size_t maxIters, double confidence,
                             size_t refineIters)
{
    return estimateAffinePartial2D(from, to, inliers, exchange(), threshold, maxIters, confidence,
                                   refineIters);
}

bool exchangedPnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray K,
                        InputArray distortion, OutputArray rvec, OutputArray tvec,
                        bool useExtrinsicGuess, int maxIters, float threshold, double confidence,
                        OutputArray inliers, int)
{
    // 5. OpenCV's flags other than SOLVEPNP_ITERATIVE ignore the guess of the pose, which can then
    //    be empty.
    useExtrinsicGuess = useExtrinsicGuess && !rvec.empty() && !tvec.empty();
    return solvePnPRansac(objectPoints, imagePoints, K, distortion, rvec, tvec, useExtrinsicGuess,
                          maxIters, threshold, confidence, inliers, exchange());
}

bool exchangedPnPRansac(InputArray objectPoints, InputArray imagePoints, InputOutputArray K,
                        InputArray distortion, OutputArray rvec, OutputArray tvec,
                        OutputArray inliers, const UsacParams& params)
{
    if (K.empty())  // 6. OpenCV also estimates an unknown camera matrix from samples of six points;
                    //    this module cannot
        return solvePnPRansac(objectPoints, imagePoints, K, distortion, rvec, tvec, inliers,
                              params);
    return solvePnPRansac(objectPoints, imagePoints, K, distortion, rvec, tvec, inliers,
                          exchange(params));
}

}  // namespace cv
