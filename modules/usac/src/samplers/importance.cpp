// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of attempts to draw a point that is new to the sample, before a pass over all
//! weights.
constexpr int TRIES = 64;

/** @brief Draws points with probabilities proportional to their weights w_i (Params::scores).

A point is drawn with probability w_i / sum(w), and again if it is already in the sample. The k-th
point thus has the probability w_i / (sum(w) - sum of the weights drawn before). Points of weight 0
are not drawn unless fewer than m points have a positive weight: then each sample contains all of
these, and the rest is uniform among the points of weight 0.

Walker's alias method @cite walker1977efficient in the form of Vose @cite vose1991linear: each of n
columns of equal probability belongs to one point up to a height and to another above it. Built once
in O(N); O(1) per draw, with the resolution of 32 random bits. If the points drawn before have
nearly all of the weight, almost every draw repeats one: after #TRIES repetitions, an O(N) pass over
the other weights finds the next point. */
class ImportanceSampler : public Sampler
{
public:
    ImportanceSampler() : positive(0), points(0), rest(0), weights(0), height(0), alias(0) {}

    void start(const Context&) CV_OVERRIDE { points = 0; }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        if (!isOrdered(context, state, sample))
            return;
        if (!points)
            build(context);
        if (positive > m)
        {
            for (int k = 0; k < m; ++k)
                sample[k] = draw(state.rng, sample, k);
            return;
        }
        std::copy(points, points + positive, sample);
        state.rng.distinct(context.points.size - positive, m - positive, sample + positive);
        for (int k = positive; k < m; ++k)
            sample[k] = rest[sample[k]];
    }

private:
    //! Uniform in [0, 1).
    static double fraction(Rng& rng) { return rng.next() * (1. / 4294967296.); }

    void build(const Context& context)
    {
        const float* scores = context.points.scores;  // negated, lower is better
        CV_Assert(scores != 0);
        const int size = context.points.size;
        points = context.arena.take<int>(size);
        rest = context.arena.take<int>(size);
        weights = context.arena.take<double>(size);
        height = context.arena.take<double>(size);
        alias = context.arena.take<int>(size);
        positive = 0;
        for (int i = 0; i < size; ++i)
            (scores[i] < 0 ? points[positive++] : rest[i - positive]) = i;
        double sum = 0;
        for (int c = 0; c < positive; ++c)
        {
            weights[c] = -(double)scores[points[c]];
            sum += weights[c];
        }
        Arena::Scope scope(context.arena);
        int *const low = scope.take<int>(positive), *const high = scope.take<int>(positive);
        int lows = 0, highs = 0;
        for (int c = 0; c < positive; ++c)
        {
            height[c] = weights[c] / sum * positive;
            alias[c] = c;
            (height[c] < 1 ? low[lows++] : high[highs++]) = c;
        }
        while (lows > 0 && highs > 0)  // a high column fills the gap above a low one
        {
            const int c = low[--lows], giver = high[highs - 1];
            alias[c] = giver;
            height[giver] -= 1 - height[c];
            if (height[giver] < 1)
            {
                --highs;
                low[lows++] = giver;
            }
        }
    }

    //! Draws a point that is not among the first `count` points of the sample.
    int draw(Rng& rng, const int* sample, int count) const
    {
        for (int i = 0; i < TRIES; ++i)
        {
            const int column = rng.uniform(positive);
            const int point = points[fraction(rng) < height[column] ? column : alias[column]];
            if (std::find(sample, sample + count, point) == sample + count)
                return point;
        }
        return drawOther(rng, sample, count);
    }

    //! The same, by the cumulative weights of the points that are not in the sample.
    int drawOther(Rng& rng, const int* sample, int count) const
    {
        double sum = 0;
        for (int c = 0; c < positive; ++c)
            if (std::find(sample, sample + count, points[c]) == sample + count)
                sum += weights[c];
        double left = fraction(rng) * sum;
        int last = -1;
        for (int c = 0; c < positive && left >= 0; ++c)
            if (std::find(sample, sample + count, points[c]) == sample + count)
            {
                last = points[c];
                left -= weights[c];
            }
        return last;
    }

    int positive;     //!< number of points of positive weight
    int* points;      //!< points of positive weight, one per column; null before the first sample
    int* rest;        //!< points of weight 0
    double* weights;  //!< weights of `points`
    double* height;   //!< below it, a column belongs to its own point
    int* alias;       //!< column of the point above that height
};

}  // namespace

Ptr<Sampler> createImportanceSampler() { return makePtr<ImportanceSampler>(); }

}  // namespace usacv20
}  // namespace cv
