// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "api/argument_names.hpp"
#include "api/find_method.hpp"

namespace cv {

using usacv20::ArgumentName;
using usacv20::calling;
using usacv20::Params;
using usacv20::paramsOf;

// Argument names of calib3d's functions. For functions with a Params, only the names of the arrays
// are translated, because the caller knows the fields of Params by their own names.
static const ArgumentName HOMOGRAPHY_NAMES[] = {{"points1", "srcPoints"},
                                                {"points2", "dstPoints"},
                                                {"threshold", "ransacReprojThreshold"},
                                                {"maxIterations", "maxIters"}};
static const ArgumentName HOMOGRAPHY_ARRAYS[] = {{"points1", "srcPoints"},
                                                 {"points2", "dstPoints"}};
static const ArgumentName FUNDAMENTAL_NAMES[] = {{"threshold", "ransacReprojThreshold"},
                                                 {"maxIterations", "maxIters"}};
static const ArgumentName ESSENTIAL_NAMES[] = {{"confidence", "prob"},
                                               {"maxIterations", "maxIters"}};
static const ArgumentName FOCAL[] = {{"cameraMatrix", "focal, pp"}};
static const ArgumentName CAMERAS_OF_PARAMS[] = {{"distCoeffs1", "dist_coeff1"},
                                                 {"distCoeffs2", "dist_coeff2"}};

//! Estimates the essential matrix of two images with different cameras.
static Mat estimate(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                    InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2,
                    OutputArray mask, const Params& params)
{
    return usacv20::Usac::create(usacv20::ESSENTIAL, points1, points2, params, cameraMatrix1,
                                 cameraMatrix2, distCoeffs1, distCoeffs2)
        ->run(mask);
}

static Matx33d cameraOf(double focal, Point2d pp)
{
    if (!(std::abs(focal) > 0 && std::abs(focal) <= DBL_MAX))
        CV_Error_(Error::StsOutOfRange,
                  ("focal, pp: a focal length in pixels is expected, not %g", focal));
    return Matx33d(focal, 0, pp.x, 0, focal, pp.y, 0, 0, 1);
}

// If a signature of calib3d has no maxIters, the default of the signature with maxIters is used.

Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method,
                   double ransacReprojThreshold, OutputArray mask, const int maxIters,
                   const double confidence)
{
    const Params params = paramsOf(method, ransacReprojThreshold, confidence, maxIters);
    return calling(HOMOGRAPHY_NAMES,
                   [&] { return usacv20::estimateHomography(srcPoints, dstPoints, params, mask); });
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                   UsacV20Method method, double ransacReprojThreshold)
{
    return findHomography(srcPoints, dstPoints, method, ransacReprojThreshold, mask);
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                   const Params& params)
{
    return calling(HOMOGRAPHY_ARRAYS,
                   [&] { return usacv20::estimateHomography(srcPoints, dstPoints, params, mask); });
}

Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                       double ransacReprojThreshold, double confidence, int maxIters,
                       OutputArray mask)
{
    const Params params = paramsOf(method, ransacReprojThreshold, confidence, maxIters);
    return calling(FUNDAMENTAL_NAMES,
                   [&] { return usacv20::estimateFundamental(points1, points2, params, mask); });
}

Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                       double ransacReprojThreshold, double confidence, OutputArray mask)
{
    return findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence, 1000,
                              mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                       UsacV20Method method, double ransacReprojThreshold, double confidence)
{
    return findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence, 1000,
                              mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                       const Params& params)
{
    return usacv20::estimateFundamental(points1, points2, params, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                     UsacV20Method method, double prob, double threshold, int maxIters,
                     OutputArray mask)
{
    const Params params = paramsOf(method, threshold, prob, maxIters);
    return calling(ESSENTIAL_NAMES, [&] {
        return usacv20::estimateEssential(points1, points2, cameraMatrix, params, mask);
    });
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                     UsacV20Method method, double prob, double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, cameraMatrix, method, prob, threshold, 1000, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                     UsacV20Method method, double prob, double threshold, int maxIters,
                     OutputArray mask)
{
    const Matx33d camera = cameraOf(focal, pp);
    return calling(FOCAL, [&] {
        return findEssentialMat(points1, points2, camera, method, prob, threshold, maxIters, mask);
    });
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                     UsacV20Method method, double prob, double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, focal, pp, method, prob, threshold, 1000, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                     InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
                     UsacV20Method method, double prob, double threshold, OutputArray mask)
{
    const Params params = paramsOf(method, threshold, prob, 1000);
    return calling(ESSENTIAL_NAMES, [&] {
        return estimate(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2,
                        mask, params);
    });
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                     InputArray cameraMatrix2, InputArray dist_coeff1, InputArray dist_coeff2,
                     OutputArray mask, const Params& params)
{
    return calling(CAMERAS_OF_PARAMS, [&] {
        return estimate(points1, points2, cameraMatrix1, cameraMatrix2, dist_coeff1, dist_coeff2,
                        mask, params);
    });
}

namespace usacv20 {

Params paramsOf(UsacV20Method method, double threshold, double confidence, int maxIterations,
                const char* name)
{
    if (!isUsacV20Method((int)method))
        CV_Error_(Error::StsBadArg,
                  ("%s: one of the flags USACV20* is expected, not %d", name, (int)method));
    Params params = Params::fromMethod(method);
    params.threshold = threshold;
    params.confidence = confidence;
    params.maxIterations = maxIterations;
    return params;
}

bool isOurs(int method, const char* name)
{
    const bool ours = isUsacV20Method(method);
    if (!ours && (method < 0 || method > 63))
        CV_Error_(Error::StsBadArg,
                  ("%s: neither one of the flags USACV20* nor one of OpenCV's: %d", name, method));
    return ours;
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, int method,
                   double ransacReprojThreshold, OutputArray mask, const int maxIters,
                   const double confidence)
{
    if (isOurs(method))
        return cv::findHomography(srcPoints, dstPoints, methodFromInt(method),
                                  ransacReprojThreshold, mask, maxIters, confidence);
    return cv::findHomography(srcPoints, dstPoints, method, ransacReprojThreshold, mask, maxIters,
                              confidence);
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask, int method,
                   double ransacReprojThreshold)
{
    return usacv20::findHomography(srcPoints, dstPoints, method, ransacReprojThreshold, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, int method,
                       double ransacReprojThreshold, double confidence, int maxIters,
                       OutputArray mask)
{
    if (isOurs(method))
        return cv::findFundamentalMat(points1, points2, methodFromInt(method),
                                      ransacReprojThreshold, confidence, maxIters, mask);
    return cv::findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence,
                                  maxIters, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, int method,
                       double ransacReprojThreshold, double confidence, OutputArray mask)
{
    return usacv20::findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence,
                                       1000, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, int method,
                       double ransacReprojThreshold, double confidence)
{
    return usacv20::findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence,
                                       1000, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, int method,
                     double prob, double threshold, int maxIters, OutputArray mask)
{
    if (isOurs(method))
        return cv::findEssentialMat(points1, points2, cameraMatrix, methodFromInt(method), prob,
                                    threshold, maxIters, mask);
    return cv::findEssentialMat(points1, points2, cameraMatrix, method, prob, threshold, maxIters,
                                mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, int method,
                     double prob, double threshold, OutputArray mask)
{
    return usacv20::findEssentialMat(points1, points2, cameraMatrix, method, prob, threshold, 1000,
                                     mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, int method,
                     double prob, double threshold, int maxIters, OutputArray mask)
{
    if (isOurs(method))
        return cv::findEssentialMat(points1, points2, focal, pp, methodFromInt(method), prob,
                                    threshold, maxIters, mask);
    return cv::findEssentialMat(points1, points2, focal, pp, method, prob, threshold, maxIters,
                                mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, int method,
                     double prob, double threshold, OutputArray mask)
{
    return usacv20::findEssentialMat(points1, points2, focal, pp, method, prob, threshold, 1000,
                                     mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                     InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
                     int method, double prob, double threshold, OutputArray mask)
{
    if (isOurs(method))
        return cv::findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2,
                                    distCoeffs2, methodFromInt(method), prob, threshold, mask);
    return cv::findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2,
                                distCoeffs2, method, prob, threshold, mask);
}

}  // namespace usacv20
}  // namespace cv
