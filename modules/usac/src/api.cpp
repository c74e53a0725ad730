// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {

namespace usacv20 {

Mat estimateHomography(InputArray points1, InputArray points2, const Params& params, OutputArray mask, Report& report)
{
    return Usac::create(HOMOGRAPHY, points1, points2, params)->run(mask, &report);
}

Mat estimateHomography(InputArray points1, InputArray points2, const Params& params, OutputArray mask)
{
    return Usac::create(HOMOGRAPHY, points1, points2, params)->run(mask);
}

Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params, OutputArray mask, Report& report)
{
    return Usac::create(FUNDAMENTAL, points1, points2, params)->run(mask, &report);
}

Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params, OutputArray mask)
{
    return Usac::create(FUNDAMENTAL, points1, points2, params)->run(mask);
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix1, InputArray cameraMatrix2,
                      InputArray distCoeffs1, InputArray distCoeffs2, const Params& params, OutputArray mask,
                      Report& report)
{
    return Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix1, cameraMatrix2, distCoeffs1,
                        distCoeffs2)->run(mask, &report);
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix, const Params& params,
                      OutputArray mask)
{
    return Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix)->run(mask);
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix, const Params& params,
                      OutputArray mask, Report& report)
{
    return Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix)->run(mask, &report);
}

} // namespace usacv20

using usacv20::Params;

static Params paramsOf(UsacV20Method method, double threshold, double confidence, int maxIterations)
{
    Params params = Params::fromMethod(method);
    params.threshold = threshold;
    params.confidence = confidence;
    params.maxIterations = maxIterations;
    return params;
}

static Matx33d cameraOf(double focal, Point2d pp)
{
    return Matx33d(focal, 0, pp.x, 0, focal, pp.y, 0, 0, 1);
}

// Where a signature of calib3d has no maxIters, its default is used.

Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method, double ransacReprojThreshold,
                   OutputArray mask, const int maxIters, const double confidence)
{
    return usacv20::estimateHomography(srcPoints, dstPoints,
                                       paramsOf(method, ransacReprojThreshold, confidence, maxIters), mask);
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask, UsacV20Method method,
                   double ransacReprojThreshold)
{
    return findHomography(srcPoints, dstPoints, method, ransacReprojThreshold, mask);
}

Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask, const Params& params)
{
    return usacv20::estimateHomography(srcPoints, dstPoints, params, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method, double ransacReprojThreshold,
                       double confidence, int maxIters, OutputArray mask)
{
    return usacv20::estimateFundamental(points1, points2,
                                        paramsOf(method, ransacReprojThreshold, confidence, maxIters), mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method, double ransacReprojThreshold,
                       double confidence, OutputArray mask)
{
    return findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence, 1000, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, UsacV20Method method,
                       double ransacReprojThreshold, double confidence)
{
    return findFundamentalMat(points1, points2, method, ransacReprojThreshold, confidence, 1000, mask);
}

Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, const Params& params)
{
    return usacv20::estimateFundamental(points1, points2, params, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, UsacV20Method method, double prob,
                     double threshold, int maxIters, OutputArray mask)
{
    return usacv20::estimateEssential(points1, points2, cameraMatrix, paramsOf(method, threshold, prob, maxIters), mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, UsacV20Method method, double prob,
                     double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, cameraMatrix, method, prob, threshold, 1000, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, UsacV20Method method, double prob,
                     double threshold, int maxIters, OutputArray mask)
{
    return findEssentialMat(points1, points2, cameraOf(focal, pp), method, prob, threshold, maxIters, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, UsacV20Method method, double prob,
                     double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, cameraOf(focal, pp), method, prob, threshold, 1000, mask);
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1, InputArray distCoeffs1,
                     InputArray cameraMatrix2, InputArray distCoeffs2, UsacV20Method method, double prob,
                     double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2, mask,
                            paramsOf(method, threshold, prob, 1000));
}

Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1, InputArray cameraMatrix2,
                     InputArray distCoeffs1, InputArray distCoeffs2, OutputArray mask, const Params& params)
{
    return usacv20::Usac::create(usacv20::ESSENTIAL, points1, points2, params, cameraMatrix1, cameraMatrix2, distCoeffs1,
                                 distCoeffs2)->run(mask);
}

} // namespace cv
