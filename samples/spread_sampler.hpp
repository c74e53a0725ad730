// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_SPREAD_SAMPLER_HPP
#define OPENCV_USACV20_SAMPLES_SPREAD_SAMPLER_HPP

#include <algorithm>
#include <vector>
#include "opencv2/usac.hpp"

namespace custom {

/** Draws the points of a sample from different cells of a grid over image 1. If too few cells
contain points, samples are uniform. A model from distant points is more accurate far from its
sample, but a model whose inliers are in a small part of the image is found later. The samples count
for the termination criteria (State::counts stays true), because any point can be drawn. */
class SpreadSampler : public cv::usacv20::Sampler
{
public:
    //! Starts a run, whose points can differ from those of the last run.
    void start(const cv::usacv20::Context& context) CV_OVERRIDE { assign(context.points); }

    void sample(const cv::usacv20::Context& context, cv::usacv20::State& state,
                int* sample) CV_OVERRIDE
    {
        const int wanted = context.components.minimalSolver->sampleSize();
        if ((int)cells.size() < wanted)
        {
            state.rng.distinct(context.points.size, wanted, sample);
            return;
        }
        int chosen[cv::usacv20::MAX_SAMPLE_SIZE];
        state.rng.distinct((int)cells.size(), wanted, chosen);
        for (int k = 0; k < wanted; ++k)
        {
            const std::vector<int>& cell = cells[chosen[k]];
            sample[k] = cell[state.rng.uniform((int)cell.size())];
        }
    }

private:
    enum { DIVISIONS = 4 };

    static int division(float value, float low, float high)
    {
        const float cell = high > low ? (value - low) * (float)DIVISIONS / (high - low) : 0;
        return std::max(0, std::min((int)cell, DIVISIONS - 1));
    }

    //! Sorts the points into cells and removes empty cells.
    void assign(const cv::usacv20::Correspondences& p)
    {
        using namespace cv::usacv20;
        std::vector<std::vector<int>> all(DIVISIONS * DIVISIONS);
        for (int i = 0; i < p.size; ++i)
            all[division(p.column[Y1][i], p.lower[1], p.upper[1]) * DIVISIONS +
                division(p.column[X1][i], p.lower[0], p.upper[0])]
                .push_back(i);
        cells.clear();
        for (size_t c = 0; c < all.size(); ++c)
            if (!all[c].empty())
                cells.push_back(all[c]);
    }

    std::vector<std::vector<int>> cells;
};

}  // namespace custom

#endif
