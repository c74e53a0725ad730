// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residuals/kernels.hpp"
#include "scores/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Most points of one block.
enum { BLOCK = 256 };

/** One model against the points: the fused kernel where score and residual have one, else errors, then score. */
class Judge
{
public:
    Judge(const Context& context, const Model& model_)
        : points(context.points), score(*context.components.score), residual(*context.components.residual),
          kernel(score.fused(residual)), limit((float)(points.threshold * points.threshold)), model(model_)
    {
        toFloat(model, m);
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
    float m[9];
};

} // namespace

Rating rate(const Context& context, const Verifier* verifier, const Model& model, double bound, int start)
{
    const Judge judge(context, model);
    const int size = context.points.size;
    Rating rating = {Quality(0, 0), false, 0, 0};
    int tested = 0;
    while (tested < size)
    {
        int position = start + tested;
        if (position >= size)
            position -= size;
        const int block = verifier ? std::max(1, std::min<int>(verifier->nextBlock(tested), BLOCK)) : (int)BLOCK;
        const int count = std::min(block, std::min(size - tested, size - position));
        judge.add(position, position + count, rating.quality);
        tested += count;
        if (rating.firstTested == 0)
        {
            rating.firstTested = tested;
            rating.firstInliers = rating.quality.inliers;
        }
        if (rating.quality.cost >= bound || (verifier && !verifier->proceed(rating.quality.inliers, tested)))
            return rating;
    }
    rating.complete = true;
    return rating;
}

Quality Context::rate(const Model& model, double bound) const
{
    return usacv20::rate(*this, 0, model, bound, 0).quality;
}

} // namespace usacv20
} // namespace cv
