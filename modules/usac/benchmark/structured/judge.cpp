// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "judge.hpp"

#include <algorithm>
#include <limits>
#include "problems/problem_kind.hpp"
#include "true_model.hpp"

namespace benchmark {

namespace {

//! A model is worse than the true model if its cost is higher by more than this multiple of an
//! outlier's cost. Differences in the polishing change the cost by less.
const double MARGIN = 0.5;
//! An inlier of the true model counts as lost if its distance from another model exceeds this many
//! thresholds.
const double LOST = 2;
//! A model that loses at most this fraction of the true model's inliers is not a search failure: it
//! counts as the true model with a less accurate refinement.
const double FEW = 0.01;
//! Limits of a right result. WRONG_ERROR is in units of the threshold or of the noise's standard
//! deviation, whichever is larger; WRONG_POSE (for E) is in degrees.
const double WRONG_ERROR = 3, WRONG_POSE = 5;

}  // namespace

Judge::Judge(const opencv_test::Scene& scene_, const ImagePair& pair_, const Settings& settings_,
             double noise)
    : scene(scene_), pair(pair_), settings(settings_),
      farLimit(WRONG_ERROR * std::max(settings_.threshold, noise)),
      bestCost(std::numeric_limits<double>::infinity())
{
    const TrueModel exact(scene);
    std::vector<int> right;
    for (int i = 0; i < scene.size(); ++i)
        if (scene.truth[i])
            right.push_back(i);
    fit = exact.leastSquares(right).matrix();
    offer(exact.matrix());
    offer(fit);
}

void Judge::offer(const cv::Mat& model)
{
    const double cost = costOf(model);
    if (!(cost < bestCost))
        return;
    bestCost = cost;
    best = model;
}

double Judge::costOf(const cv::Mat& model) const
{
    return kindOf(settings.problem).modelCost(pair, model, settings.threshold) *
           pair.points1.size();
}

double Judge::distance(const cv::Mat& model, int row) const
{
    return opencv_test::pixelError(scene, cv::Matx33d(model.ptr<double>()), pair.points1[row],
                                   pair.points2[row]);
}

bool Judge::sameInliers(const cv::Mat& model) const
{
    int inliers = 0, lost = 0;
    for (int i = 0; i < scene.size(); ++i)
        if (distance(best, i) < settings.threshold)
        {
            ++inliers;
            lost += !(distance(model, i) < LOST * settings.threshold);
        }
    return lost <= FEW * inliers;
}

Verdict Judge::judge(const Estimate& estimate) const
{
    Verdict verdict;
    const ProblemKind& kind = kindOf(settings.problem);
    verdict.error = kind.modelError(pair, estimate.model);
    verdict.poseError = settings.problem == cv::usacv20::ESSENTIAL ? kind.poseError(pair, estimate)
                                                                   : -1;
    verdict.none = !(verdict.error < std::numeric_limits<double>::infinity());
    verdict.far = !(verdict.error <= farLimit);
    verdict.wrong = verdict.poseError < 0 ? verdict.far
                                          : verdict.none || verdict.poseError > WRONG_POSE;
    verdict.worse = verdict.none || costOf(estimate.model) > bestCost + MARGIN;
    verdict.failed = verdict.none;
    if (verdict.worse && !verdict.none)
    {
        cv::Mat model;
        estimate.model.rowRange(0, 3).convertTo(model, CV_64F);
        verdict.failed = !sameInliers(model);
    }
    return verdict;
}

}  // namespace benchmark
