// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "degeneracy/degeneracy.hpp"
#include "degeneracy/share_a_point.hpp"
#include "residuals/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Tells whether a match is an inlier whatever one of its ends is, see SharedPoints. `scale`: size of image 2 over that of image
1. */
class OneEnd
{
public:
    OneEnd(const Model& F, double scale) : most1((float)square(FAR_APART / scale)), most2((float)square(FAR_APART * scale))
    {
        toFloat(F, f);
    }

    bool counts(float x1, float y1, float x2, float y2) const
    {
        const float n2 = square(f[0] * x1 + f[1] * y1 + f[2]) + square(f[3] * x1 + f[4] * y1 + f[5]);
        const float n1 = square(f[0] * x2 + f[3] * y2 + f[6]) + square(f[1] * x2 + f[4] * y2 + f[7]);
        return (n2 > most1 * n1) | (n1 > most2 * n2);
    }

private:
    float f[9];
    const float most1, most2;
};

/** @brief F, E: matches of many points to one, however noisy, are no independent evidence.

Matches of one target (repeated patterns, matching without cross-check) are fitted by every epipolar geometry whose epipole is the
target, whatever their other ends are; those of two targets, or of points on a line, by an F of nearly rank 1, to which all
epipolar lines are that line. So

- samples are refused in which two matches share a point (shareATarget);
- of a new best model, the inliers that would be inliers whatever their other ends were count as one. Quality is changed by the
  rest of them. The model stays, as there may be no better one; but it does not beat those with real support any more.

Which inliers these are: where the line F^T x2 has next to no normal (its first two entries), a shift of x2 within the noise turns
it anywhere, and x1 tells nothing. The lengths of the normals of F x1 and F^T x2 are as the distances of neighboring epipolar
lines in the two images, which in right geometries are as the local scales; a ratio of #FAR_APART times that of the images' sizes
is taken for too much. Points beside the epipole of a camera that moves forwards are beside both epipoles, and pass.

The first #LOOKED_AT points tell whether it is worth while to look at the others. Qualities that are no sum over the points are
left. */
class SharedPoints : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        const float limit = (float)square(2 * p.threshold);
        float x1[MAX_SAMPLE_SIZE], y1[MAX_SAMPLE_SIZE], x2[MAX_SAMPLE_SIZE], y2[MAX_SAMPLE_SIZE];
        for (int i = 0; i < m; ++i)
        {
            x1[i] = p.x1[sample[i]];
            y1[i] = p.y1[sample[i]];
            x2[i] = p.x2[sample[i]];
            y2[i] = p.y2[sample[i]];
            for (int k = 0; k < i; ++k)  // most are near each other in neither image
            {
                const float first = square(x1[i] - x1[k]) + square(y1[i] - y1[k]);
                const float second = square(x2[i] - x2[k]) + square(y2[i] - y2[k]);
                if ((first <= limit || second <= limit) && shareATarget(p, sample[i], sample[k]))
                    return false;
            }
        }
        return true;
    }

    bool mayBeGood(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return onlyRepeats(context.points, sample, context.components.minimalSolver->sampleSize());
    }

    bool recover(const Context& context, State&, const int*, Model& model, Quality& quality) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const Score& score = *context.components.score;
        if (score.wholeModel())
            return true;
        const OneEnd one(model, scaleOf(p));
        int seen = 0;
        for (int i = 0; i < std::min<int>(p.size, LOOKED_AT); ++i)
            seen += one.counts(p.x1[i], p.y1[i], p.x2[i], p.y2[i]);
        if (seen < FEW)
            return true;
        find(p, one);
        const int count = (int)coordinates[0].size();
        errors.resize(count);
        context.components.residual->squaredErrors(model, coordinates[0].data(), coordinates[1].data(), coordinates[2].data(),
                                                   coordinates[3].data(), count, errors.data());
        floats.assign(errors.begin(), errors.end());
        Quality sum(0, 0);
        score.accumulate(floats.data(), count, (float)(p.threshold * p.threshold), sum);
        if (sum.inliers < 2)
            return true;
        quality.cost += (count - sum.cost) * (sum.inliers - 1) / sum.inliers;
        quality.inliers = std::max(quality.inliers - sum.inliers + 1, 1);
        return true;
    }

private:
    //! Fewer than 5 % of the first points are no matter; all of few points are looked at.
    enum { LOOKED_AT = 64, FEW = 3 };

    //! Size of image 2 over that of image 1, as far as there are points; a quarter to four, as matches of one target hide the
    //! size.
    static double scaleOf(const Correspondences& p)
    {
        double sides[4];
        for (int k = 0; k < 4; ++k)
            sides[k] = (double)p.upper[k] - p.lower[k];
        const double ratio = (sides[2] + sides[3]) / (sides[0] + sides[1]);
        return ratio > 0.25 ? std::min(ratio, 4.) : 0.25;
    }

    void find(const Correspondences& p, const OneEnd& one)
    {
        const double* const from[4] = {p.dx1, p.dy1, p.dx2, p.dy2};
        for (int k = 0; k < 4; ++k)
            coordinates[k].clear();
        for (int i = 0; i < p.size; ++i)
            if (one.counts(p.x1[i], p.y1[i], p.x2[i], p.y2[i]))
                for (int k = 0; k < 4; ++k)
                    coordinates[k].push_back(from[k][i]);
    }

    std::vector<double> coordinates[4], errors;  //!< of the matches that tell nothing
    std::vector<float> floats;
};

} // namespace

Ptr<Degeneracy> createSharedPoints()
{
    return makePtr<SharedPoints>();
}

} // namespace usacv20
} // namespace cv
