// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "samplers/samplers.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of attempts to draw a point that is not yet in the sample. If all attempts fail,
//! a pass over all weights finds the point.
constexpr int MOST_DRAWS = 64;

/** @brief Draws points with probabilities proportional to their weights w_i (Params::scores).

A point is drawn with probability w_i / sum(w); if it is already in the sample, the draw is
repeated. A point i that is not in the sample is thus the next one with probability w_i / s, where s
is the sum of the weights of all points that are not in the sample. Samples that are uniform because
of Params::orderedEvery can also contain points of weight 0. Other samples contain such points only
if fewer than m points (m is the sample size) have a positive weight: each sample then consists of
all points of positive weight and of uniformly drawn points of weight 0.

The sampler uses Walker's alias method @cite walker1977efficient in the form of Vose @cite
vose1991linear: the n points of positive weight have columns of equal probability. A column belongs
to its point up to a height, and to another point above this height. The columns are built once per
run in O(n); a draw takes O(1) and has the resolution of 32 random bits. If the points already in
the sample have nearly all of the weight, almost every draw repeats one of them. After #MOST_DRAWS
repetitions, an O(n) pass over the other weights finds the next point. */
class ImportanceSampler : public Sampler
{
public:
    ImportanceSampler() : positive(0), points(0), rest(0), weights(0), height(0), alias(0) {}

    void start(const Context&) CV_OVERRIDE { points = 0; }

    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        if (!isOrdered(context, state, m, sample))
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
    //! A uniform random number in [0, 1).
    static double fraction(Rng& rng) { return rng.next() * (1. / 4294967296.); }

    void build(const Context& context)
    {
        const float* scores = context.points.scores;  // the negated weights: lower is better
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
        while (lows > 0 && highs > 0)  // a column above 1 fills the gap above a column below 1
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
        for (int i = 0; i < MOST_DRAWS; ++i)
        {
            const int column = rng.uniform(positive);
            const int point = points[fraction(rng) < height[column] ? column : alias[column]];
            if (std::find(sample, sample + count, point) == sample + count)
                return point;
        }
        return drawOther(rng, sample, count);
    }

    //! The same as draw(), but in one attempt: from the cumulative weights of all points that are
    //! not in the sample.
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
    int* points;      //!< points of positive weight, one per column; null: not built yet
    int* rest;        //!< points of weight 0
    double* weights;  //!< weights of `points`
    double* height;   //!< height, 0 to 1, up to which a column belongs to its own point
    int* alias;       //!< for each column, the column whose point gets the part above the height
};

}  // namespace

Ptr<Sampler> createImportanceSampler() { return makePtr<ImportanceSampler>(); }

}  // namespace usacv20
}  // namespace cv
