// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "measures.hpp"

#include "problems/problem_kind.hpp"

namespace benchmark {

double modelError(const ImagePair& pair, ProblemType problem, const cv::Mat& model)
{
    return kindOf(problem).modelError(pair, model);
}

double failureLimit(const ImagePair& pair, ProblemType problem)
{
    return kindOf(problem).failureLimit(pair);
}

double modelCost(const ImagePair& pair, ProblemType problem, const cv::Mat& model, double threshold)
{
    return kindOf(problem).modelCost(pair, model, threshold);
}

double poseError(const ImagePair& pair, ProblemType problem, const Estimate& estimate)
{
    return kindOf(problem).poseError(pair, estimate);
}

}  // namespace benchmark
