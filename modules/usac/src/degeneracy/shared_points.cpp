// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "degeneracy/degeneracy.hpp"
#include "degeneracy/share_a_point.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Squared length of the first two entries of A x, A being the rows that are given.
double squaredNormal(double a0, double a1, double a2, double b0, double b1, double b2, double x, double y)
{
    return square(a0 * x + a1 * y + a2) + square(b0 * x + b1 * y + b2);
}

/** @brief F, E: matches of many points to one, however noisy, are no independent evidence.

Matches of one target (repeated patterns, matching without cross-check) are fitted by every epipolar geometry whose epipole is the
target, whatever their other ends are; those of two targets, or of points on a line, by an F of nearly rank 1, to which all
epipolar lines are that line. So

- samples are refused in which two matches share a point (shareAPoint, shareATarget);
- of a new best model, the inliers that would be inliers whatever their other ends were count as one. Quality is changed by the
  rest of them. The model stays, as there may be no better one; but it does not beat those with real support any more.

Which inliers these are: where the line F^T x2 has next to no normal (its first two entries), a shift of x2 within the noise turns
it anywhere, and x1 tells nothing. The lengths of the normals of F x1 and F^T x2 are as the distances of neighbouring epipolar lines in
the two images, which in right geometries are as the local scales; a ratio of #FAR_APART times that of the images' sizes is
taken for too much. Points beside the epipole of a camera that moves forwards are beside both epipoles, and pass.

The first #LOOKED_AT points tell whether it is worth while to look at all. Qualities that are no sum over the points are left. */
class SharedPoints : public Degeneracy
{
public:
    SharedPoints() : scale(0) {}

    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        for (int i = 1; i < m; ++i)
            for (int k = 0; k < i; ++k)
                if (shareAPoint(p, sample[i], sample[k]) || shareATarget(p, sample[i], sample[k]))
                    return false;
        return true;
    }

    bool recover(const Context& context, State&, const int*, Model& model, Quality& quality) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const Score& score = *context.components.score;
        if (score.wholeModel())
            return true;
        if (scale == 0)
            scale = scaleOf(p);
        const float limit = (float)(p.threshold * p.threshold);
        for (int end = std::min<int>(p.size, LOOKED_AT), wanted = FEW; ; end = p.size, wanted = 2)
        {
            find(p, model, end);
            const int count = (int)coordinates[0].size();
            if (count < wanted)
                return true;
            errors.resize(count);
            context.components.residual->squaredErrors(model, coordinates[0].data(), coordinates[1].data(),
                                                       coordinates[2].data(), coordinates[3].data(), count, errors.data());
            floats.assign(errors.begin(), errors.end());
            Quality sum(0, 0);
            score.accumulate(floats.data(), count, limit, sum);
            if (sum.inliers < wanted)
                return true;
            if (end < p.size)
                continue;
            quality.cost += (count - sum.cost) * (sum.inliers - 1) / sum.inliers;
            quality.inliers -= sum.inliers - 1;
            return true;
        }
    }

private:
    //! Of the first so many points, fewer than these are no matter: 5 %.
    enum { LOOKED_AT = 64, FEW = 3 };

    //! Size of image 2 over that of image 1, as far as there are points.
    static double scaleOf(const Correspondences& p)
    {
        const float* const from[4] = {p.x1, p.y1, p.x2, p.y2};
        double sides[4];
        for (int k = 0; k < 4; ++k)
            sides[k] = *std::max_element(from[k], from[k] + p.size) - *std::min_element(from[k], from[k] + p.size);
        const double ratio = (sides[2] + sides[3]) / (sides[0] + sides[1]);
        return ratio > 0 && ratio <= FLT_MAX ? ratio : 1;
    }

    //! Those of the first `end` matches whose one end tells nothing of the other.
    void find(const Correspondences& p, const Model& F, int end)
    {
        const double most1 = square(FAR_APART / scale), most2 = square(FAR_APART * scale);
        for (int k = 0; k < 4; ++k)
            coordinates[k].clear();
        for (int i = 0; i < end; ++i)
        {
            const double n2 = squaredNormal(F(0, 0), F(0, 1), F(0, 2), F(1, 0), F(1, 1), F(1, 2), p.dx1[i], p.dy1[i]);
            const double n1 = squaredNormal(F(0, 0), F(1, 0), F(2, 0), F(0, 1), F(1, 1), F(2, 1), p.dx2[i], p.dy2[i]);
            if (n2 <= most1 * n1 && n1 <= most2 * n2)
                continue;
            coordinates[0].push_back(p.dx1[i]);
            coordinates[1].push_back(p.dy1[i]);
            coordinates[2].push_back(p.dx2[i]);
            coordinates[3].push_back(p.dy2[i]);
        }
    }

    double scale;  //!< 0: not yet known
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
