// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/scenes.hpp"

#include <cmath>

namespace opencv_test {

using namespace cv;

namespace {

//! Side of the square of SCORES_OF_PLACE in pixels.
const double SCORED_PATCH = 160;

//! Scores other than SCORES_OF_TRUTH, see ScoreModel. Except with SCORES_NEAR, preferred matches
//! have scores between 0 and 1, and all other matches between 1 and 2; lower is better.
std::vector<float> makeMisleadingScores(const Scene& scene, const SceneOptions& options)
{
    RNG rng(0x3c6ef372 + 7919 * options.seed);
    const int size = scene.size();
    int middle = rng.uniform(0, size);
    while (!scene.truth[middle])
        middle = (middle + 1) % size;
    const Point2d place = scene.points1[middle];
    std::vector<float> result;
    for (int i = 0; i < size; ++i)
    {
        const Point2d offset = scene.points1[i] - place;
        const bool near = std::max(std::abs(offset.x), std::abs(offset.y)) < SCORED_PATCH / 2;
        const double score = rng.uniform(0., 1.);
        if (options.scoreModel == SCORES_NEAR)
            result.push_back(
                (float)(cv::norm(offset) / cv::norm(Point2d(SCENE_WIDTH, SCENE_HEIGHT))));
        else if (options.scoreModel == SCORES_OF_SECOND)
            result.push_back((float)(scene.onSecond[i] ? score : 1 + score));
        else
            result.push_back((float)(scene.truth[i] && near ? score : 1 + score));
    }
    return result;
}

}  // namespace

//! Scores are drawn with a random generator of their own, so that the points do not depend on them.
std::vector<float> makeScores(const std::vector<uchar>& truth, double information, uint64 seed)
{
    const double q = information;
    CV_Assert(q > 0 && q <= 1);
    RNG rng(0x9e3779b9 + 7919 * seed);
    std::vector<float> result;
    for (size_t i = 0; i < truth.size(); ++i)
    {
        const double u = rng.uniform(0., 1.);
        result.push_back((float)(truth[i] ? 1 - std::pow(u, (1 - q) / q) : u));
    }
    return result;
}

std::vector<float> makeScores(const Scene& scene, const SceneOptions& options)
{
    return options.scoreModel == SCORES_OF_TRUTH
               ? makeScores(scene.truth, options.scoreInformation, options.seed)
               : makeMisleadingScores(scene, options);
}

}  // namespace opencv_test
