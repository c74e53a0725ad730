// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of points in a block; the errors of a block stay in the L1 cache.
constexpr int BLOCK = 256;

/** Scores one model on blocks of points: with the fused kernel if score and residual have one,
otherwise by first computing the errors and then their score. */
class BlockScorer
{
public:
    BlockScorer(const Context& context, const Score& score_, const Model& model_)
        : points(context.points), score(score_), residual(*context.components.residual),
          kernel(score.fused(residual)), limit((float)(points.threshold * points.threshold)),
          model(model_)
    {
        toFloat(model, m, residual.homogeneous());
    }

    void add(int begin, int end, Quality& sum) const
    {
        if (kernel)
        {
            kernel(points, m, limit, begin, end, sum);
            return;
        }
        float errors[BLOCK];
        residual.squaredErrors(points, model, begin, end, errors);
        score.accumulate(errors, end - begin, limit, sum);
    }

private:
    const Correspondences& points;
    const Score& score;
    const Residual& residual;
    const FusedKernel kernel;
    const float limit;
    const Model& model;
    float m[MAX_MODEL_SIZE];
};

//! Scores the model block by block, beginning at point `start`. @param verifier may be null
//! @return false if the verifier has rejected the model or if the cost has reached `bound`
bool rateBlocks(const BlockScorer& scorer, int size, const Verifier* verifier, double bound,
                int start, Rating& rating)
{
    int tested = 0;
    while (tested < size)
    {
        int position = start + tested;
        if (position >= size)
            position -= size;
        const int block = verifier ? std::max(1, std::min<int>(verifier->nextBlock(tested), BLOCK))
                                   : BLOCK;
        const int count = std::min(block, std::min(size - tested, size - position));
        rating.costBefore = rating.quality.cost;
        scorer.add(position, position + count, rating.quality);
        tested += count;
        if (rating.firstTested == 0)
        {
            rating.firstTested = tested;
            rating.firstInliers = rating.quality.inliers;
        }
        rating.refused = verifier && !verifier->proceed(rating.quality.inliers, tested);
        if (rating.refused || rating.quality.cost >= bound)
            return false;
    }
    return true;
}

//! Scores the model with a score that needs all errors at once. The verifier, if any, first tests
//! the model with the numbers of inliers in blocks of points.
void rateWhole(const Context& context, const Verifier* verifier, const Model& model, double bound,
               int start, Rating& rating, float* errors)
{
    const Correspondences& points = context.points;
    const InlierScore counter;
    if (verifier && !rateBlocks(BlockScorer(context, counter, model), points.size, verifier,
                                DBL_MAX, start, rating))
    {
        rating.costBefore = 0;  // until now it was the number of outliers, not a cost of this score
        return;
    }
    context.components.residual->squaredErrors(points, model, 0, points.size, errors);
    rating.quality = Quality(0, 0);
    const float limit = (float)(points.threshold * points.threshold);
    context.components.score->accumulate(errors, points.size, limit, rating.quality);
    rating.complete = rating.quality.cost < bound;
}

}  // namespace

Rating rate(const Context& context, const Verifier* verifier, const Model& model, double bound,
            int start, float* errors)
{
    Rating rating = {Quality(0, 0), false, false, 0, 0, 0};
    const Score& score = *context.components.score;
    if (score.wholeModel())
        rateWhole(context, verifier, model, bound, start, rating, errors);
    else
        rating.complete = rateBlocks(BlockScorer(context, score, model), context.points.size,
                                     verifier, bound, start, rating);
    return rating;
}

Quality Context::rate(const Model& model, double bound) const
{
    Arena::Scope scope(arena);
    float* const errors = components.score->wholeModel() ? scope.take<float>(points.size) : 0;
    return usacv20::rate(*this, 0, model, bound, 0, errors).quality;
}

}  // namespace usacv20
}  // namespace cv
