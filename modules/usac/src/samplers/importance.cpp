// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Points as often as their weights w_i, Params::scores, say.

A point is drawn with probability w_i / sum(w), a repeated one is drawn again; so the k-th point has the probability
w_i / (sum(w) - sum of the points drawn before). Points of weight 0 are not drawn, unless fewer than m others exist:
then all of these are in each sample, and the rest is uniform among the points of weight 0.

Walker's alias method @cite walker1977efficient in the form of Vose @cite vose1991linear: of n columns of equal
probability each belongs to one point up to a height and to another one above it. Built once in O(N); O(1) a draw, with
the resolution of 32 random bits. Where the points drawn before have nearly all of the weight, repetitions do not end:
after #TRIES of them the next point is found by a pass over the other weights, O(N). */
class ImportanceSampler : public Sampler
{
public:
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        if (!isOrdered(context, state, sample))
            return;
        if (points.empty() && rest.empty())
            build(context);
        const int positive = (int)points.size();
        if (positive > m)
        {
            for (int k = 0; k < m; ++k)
                sample[k] = draw(state.rng, sample, k);
            return;
        }
        std::copy(points.begin(), points.end(), sample);
        state.rng.distinct((int)rest.size(), m - positive, sample + positive);
        for (int k = positive; k < m; ++k)
            sample[k] = rest[sample[k]];
    }

private:
    enum { TRIES = 64 };

    //! Uniform in [0, 1).
    static double fraction(Rng& rng) { return rng.next() * (1. / 4294967296.); }

    void build(const Context& context)
    {
        const float* scores = context.points.scores;  // negated, lower is better
        CV_Assert(scores != 0);
        for (int i = 0; i < context.points.size; ++i)
            (scores[i] < 0 ? points : rest).push_back(i);
        double sum = 0;
        for (size_t c = 0; c < points.size(); ++c)
        {
            weights.push_back(-(double)scores[points[c]]);
            sum += weights[c];
        }
        height.resize(points.size());
        alias.resize(points.size());
        std::vector<int> low, high;
        for (size_t c = 0; c < points.size(); ++c)
        {
            height[c] = weights[c] / sum * points.size();
            alias[c] = (int)c;
            (height[c] < 1 ? low : high).push_back((int)c);
        }
        while (!low.empty() && !high.empty())  // the gap above a low column is filled from a high one
        {
            const int c = low.back(), giver = high.back();
            low.pop_back();
            alias[c] = giver;
            height[giver] -= 1 - height[c];
            if (height[giver] < 1)
            {
                high.pop_back();
                low.push_back(giver);
            }
        }
    }

    //! A point that is not among the first `count` of the sample.
    int draw(Rng& rng, const int* sample, int count) const
    {
        for (int i = 0; i < TRIES; ++i)
        {
            const int column = rng.uniform((int)points.size());
            const int point = points[fraction(rng) < height[column] ? column : alias[column]];
            if (std::find(sample, sample + count, point) == sample + count)
                return point;
        }
        return drawOther(rng, sample, count);
    }

    //! The same by the cumulative weights of the other points.
    int drawOther(Rng& rng, const int* sample, int count) const
    {
        double sum = 0;
        for (size_t c = 0; c < points.size(); ++c)
            if (std::find(sample, sample + count, points[c]) == sample + count)
                sum += weights[c];
        double left = fraction(rng) * sum;
        int last = -1;
        for (size_t c = 0; c < points.size() && left >= 0; ++c)
            if (std::find(sample, sample + count, points[c]) == sample + count)
            {
                last = points[c];
                left -= weights[c];
            }
        return last;
    }

    std::vector<int> points;      //!< of positive weight, one a column
    std::vector<int> rest;        //!< of weight 0
    std::vector<double> weights;  //!< of `points`
    std::vector<double> height;   //!< up to where a column belongs to its own point
    std::vector<int> alias;       //!< the column of the other point
};

}  // namespace

Ptr<Sampler> createImportanceSampler() { return makePtr<ImportanceSampler>(); }

}  // namespace usacv20
}  // namespace cv
