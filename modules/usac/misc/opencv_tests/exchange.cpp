// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "exchange.hpp"

#undef findHomography
#undef findFundamentalMat
#undef findEssentialMat

namespace cv {

UsacV20Method Exchange::flag = USACV20;
int Exchange::calls = 0;

static UsacV20Method exchange()
{
    ++Exchange::calls;
    return Exchange::flag;
}

static usacv20::Params exchange(const UsacParams& given)
{
    usacv20::Params params = usacv20::Params::fromMethod(exchange());
    params.threshold = given.threshold;
    params.confidence = given.confidence;
    params.maxIterations = given.maxIterations;
    return params;
}

// Two of the documented differences are taken back here, so that the tests see the rest. cv::findFundamentalMat takes a confidence
// of 0 or 1 for 0.99, where this module raises an exception, and its F has f33 = 1, where this one's has unit norm.

static double confidenceOf(double confidence)
{
    return confidence > 0 && confidence < 1 ? confidence : 0.99;
}

static Mat scaled(const Mat& F)
{
    return F.empty() || F.at<double>(2, 2) == 0 ? F : Mat(F / F.at<double>(2, 2));
}

Mat exchangedHomography(InputArray points1, InputArray points2, int, double threshold, OutputArray mask, int maxIters,
                        double confidence)
{
    return findHomography(points1, points2, exchange(), threshold, mask, maxIters, confidence);
}

Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask, int, double threshold)
{
    return findHomography(points1, points2, mask, exchange(), threshold);
}

Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask, const UsacParams& params)
{
    return findHomography(points1, points2, mask, exchange(params));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int, double threshold, double confidence, int maxIters,
                            OutputArray mask)
{
    return scaled(findFundamentalMat(points1, points2, exchange(), threshold, confidenceOf(confidence), maxIters, mask));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int, double threshold, double confidence, OutputArray mask)
{
    return scaled(findFundamentalMat(points1, points2, exchange(), threshold, confidenceOf(confidence), mask));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, int, double threshold, double confidence)
{
    return scaled(findFundamentalMat(points1, points2, mask, exchange(), threshold, confidenceOf(confidence)));
}

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, const UsacParams& params)
{
    return scaled(findFundamentalMat(points1, points2, mask, exchange(params)));
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int, double confidence, double threshold,
                          int maxIters, OutputArray mask)
{
    return findEssentialMat(points1, points2, K, exchange(), confidence, threshold, maxIters, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int, double confidence, double threshold,
                          OutputArray mask)
{
    return findEssentialMat(points1, points2, K, exchange(), confidence, threshold, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, int, double confidence,
                          double threshold, int maxIters, OutputArray mask)
{
    return findEssentialMat(points1, points2, focal, pp, exchange(), confidence, threshold, maxIters, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, int, double confidence,
                          double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, focal, pp, exchange(), confidence, threshold, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1, InputArray distortion1, InputArray K2,
                          InputArray distortion2, int, double confidence, double threshold, OutputArray mask)
{
    return findEssentialMat(points1, points2, K1, distortion1, K2, distortion2, exchange(), confidence, threshold, mask);
}

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1, InputArray K2, InputArray distortion1,
                          InputArray distortion2, OutputArray mask, const UsacParams& params)
{
    return findEssentialMat(points1, points2, K1, K2, distortion1, distortion2, mask, exchange(params));
}

} // namespace cv
