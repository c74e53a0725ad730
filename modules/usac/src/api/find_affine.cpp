// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "api/argument_names.hpp"
#include "api/find_method.hpp"

#include <climits>

namespace cv {

using usacv20::ArgumentName;
using usacv20::calling;
using usacv20::Params;

// Argument names of calib3d's functions. For functions with a Params, only the names of the arrays
// are translated, because the caller knows the fields of Params by their own names.
static const ArgumentName AFFINE_NAMES[] = {{"points1", "from"},
                                            {"points2", "to"},
                                            {"threshold", "ransacReprojThreshold"},
                                            {"maxIterations", "maxIters"},
                                            {"polishingSteps", "refineIters"}};
static const ArgumentName ARRAYS_OF_PARAMS[] = {{"points1", "pts1"}, {"points2", "pts2"}};

//! Converts a `size_t` argument of calib3d's functions to int. A number above INT_MAX raises
//! a cv::Exception; so does a negative number, because the conversion to `size_t` makes it huge.
static int countOf(const char* name, size_t count)
{
    if (count > (size_t)INT_MAX)
        CV_Error_(Error::StsOutOfRange, ("%s: at most %d is expected, not %llu", name, INT_MAX,
                                         (unsigned long long)count));
    return (int)count;
}

static Params paramsOf(UsacV20Method method, double threshold, size_t maxIters, double confidence,
                       size_t refineIters)
{
    Params params = usacv20::paramsOf(method, threshold, confidence, countOf("maxIters", maxIters));
    const int steps = countOf("refineIters", refineIters);
    if (steps == 0)
        params.polishing = usacv20::POLISHING_NONE;
    else
        params.polishingSteps = std::min(params.polishingSteps, steps);
    return params;
}

Mat estimateAffine2D(InputArray from, InputArray to, OutputArray inliers, UsacV20Method method,
                     double ransacReprojThreshold, size_t maxIters, double confidence,
                     size_t refineIters)
{
    const Params params = paramsOf(method, ransacReprojThreshold, maxIters, confidence,
                                   refineIters);
    return calling(AFFINE_NAMES,
                   [&] { return usacv20::estimateAffinity2D(from, to, params, inliers); });
}

Mat estimateAffine2D(InputArray pts1, InputArray pts2, OutputArray inliers, const Params& params)
{
    return calling(ARRAYS_OF_PARAMS,
                   [&] { return usacv20::estimateAffinity2D(pts1, pts2, params, inliers); });
}

Mat estimateAffinePartial2D(InputArray from, InputArray to, OutputArray inliers,
                            UsacV20Method method, double ransacReprojThreshold, size_t maxIters,
                            double confidence, size_t refineIters)
{
    const Params params = paramsOf(method, ransacReprojThreshold, maxIters, confidence,
                                   refineIters);
    return calling(AFFINE_NAMES,
                   [&] { return usacv20::estimateSimilarity2D(from, to, params, inliers); });
}

Mat estimateAffinePartial2D(InputArray pts1, InputArray pts2, OutputArray inliers,
                            const Params& params)
{
    return calling(ARRAYS_OF_PARAMS,
                   [&] { return usacv20::estimateSimilarity2D(pts1, pts2, params, inliers); });
}

namespace usacv20 {

Mat estimateAffine2D(InputArray from, InputArray to, OutputArray inliers, int method,
                     double ransacReprojThreshold, size_t maxIters, double confidence,
                     size_t refineIters)
{
    if (isOurs(method))
        return cv::estimateAffine2D(from, to, inliers, methodFromInt(method), ransacReprojThreshold,
                                    maxIters, confidence, refineIters);
    return cv::estimateAffine2D(from, to, inliers, method, ransacReprojThreshold, maxIters,
                                confidence, refineIters);
}

Mat estimateAffinePartial2D(InputArray from, InputArray to, OutputArray inliers, int method,
                            double ransacReprojThreshold, size_t maxIters, double confidence,
                            size_t refineIters)
{
    if (isOurs(method))
        return cv::estimateAffinePartial2D(from, to, inliers, methodFromInt(method),
                                           ransacReprojThreshold, maxIters, confidence,
                                           refineIters);
    return cv::estimateAffinePartial2D(from, to, inliers, method, ransacReprojThreshold, maxIters,
                                       confidence, refineIters);
}

}  // namespace usacv20
}  // namespace cv
