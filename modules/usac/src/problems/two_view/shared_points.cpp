// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/selection.hpp"
#include "problems/two_view/two_view.hpp"
#include "components/point_subset.hpp"
#include "problems/share_a_point.hpp"
#include "residual/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

// In this file, the two ends of a match are its point in image 1 and its point in image 2.

//! The quality is lowered only if at least FEW of the first LOOKED_AT matches would be inliers for
//! every position of one of their ends.
constexpr int LOOKED_AT = 64, FEW = 8;
//! Many matches share points if at least SHARED_PAIRS pairs of the first FIRST_PAIRS matches (3 %
//! of all pairs of these matches) share a point up to noise, see shareATarget(). For comparison: if
//! each of two points has a third of all matches, a fifth of the pairs share a point.
constexpr int FIRST_PAIRS = 32, SHARED_PAIRS = 16;
//! The extent of the first points is computed without the smallest and the largest 1 / TRIMMED of
//! their coordinates.
constexpr int TRIMMED = 10;

//! A match counts as not constraining F only if a shift of one end by this many thresholds moves
//! the epipolar line across the whole other image. It must also fulfill the condition with
//! #FAR_APART, see SharedPoints. In images of 640 pixels, that condition is stricter if the
//! threshold exceeds 1.1 pixels.
constexpr double ANYWHERE = 60;

/** Tests whether a match would be an inlier of F for every position of one of its two ends, see
SharedPoints. `sizes` are the extents of the points in the two images. */
class InsensitivityTest
{
public:
    InsensitivityTest(const Model& F, const float* sizes, double threshold)
        : most1((float)square(std::max<double>(FAR_APART / sizes[1], 1 / (ANYWHERE * threshold)) *
                              sizes[0])),
          most2((float)square(std::max<double>(FAR_APART / sizes[0], 1 / (ANYWHERE * threshold)) *
                              sizes[1]))
    {
        toFloat(F, f);
    }

    bool holds(float x1, float y1, float x2, float y2) const
    {
        const float n2 = square(f[0] * x1 + f[1] * y1 + f[2]) +
                         square(f[3] * x1 + f[4] * y1 + f[5]);
        const float n1 = square(f[0] * x2 + f[3] * y2 + f[6]) +
                         square(f[1] * x2 + f[4] * y2 + f[7]);
        return (n2 > most1 * n1) | (n1 > most2 * n2);
    }

private:
    float f[9];
    const float most1, most2;
};

/** @brief Check for F and E: matches of many points to one point are not independent evidence, even
if they are noisy.

Matches to one point, called a target here (repeated patterns, matching without cross-check), are
inliers of every epipolar geometry whose epipole is the target, for every position of their other
ends. Matches to two targets, or to points on a line, are inliers of an F of nearly rank 1 whose
epipolar lines all coincide with the line through these targets or points. Therefore
- samples are rejected in which two matches share a point. If many matches share points, points that
are the same up to noise count as shared, too, see shareATarget(). If few matches share points, two
matches whose points are close together in one image can both be correct;
- in the quality of each new best model, all inliers that would be inliers for every position of one
of their ends count as a single inlier. The model is kept, because there may be no better model, but
its score is no longer better than that of correct models.

These inliers are recognized as follows. If the normal of the epipolar line F^T x2 (its first two
entries) is nearly 0, a shift of x2 within the noise turns the line to any direction, so that x1 is
not constrained. The ratio of the lengths of the normals of F x1 and F^T x2 is the ratio of the
distances between neighboring epipolar lines in the two images. For correct geometries this is the
ratio of the local scales. The ratio is too large if it exceeds #FAR_APART times the ratio of the
image sizes and if a shift of one end by #ANYWHERE thresholds moves the epipolar line across the
whole other image. (The first condition alone is not enough: if a camera is in the middle of the
scene, the scale varies by factors of hundreds within its image.) If a camera moves forward, points
near one epipole are near the other epipole, too, so that the ratio is not too large for their
matches.

The first #LOOKED_AT points decide whether the other points are tested at all. The quality is not
changed for scores that are not a sum over the points. */
class SharedPoints : public Degeneracy
{
public:
    SharedPoints() : targets(false) { sizes[0] = sizes[1] = FLT_MIN; }

    /** Estimates the extents of the points in both images in two ways: from the box
    Correspondences::lower, upper, which is robust against a few points far from the other points,
    and from the first points without the outermost ones, which is robust against many matches to
    one target. The estimate whose two extents are more nearly equal is used, because most image
    pairs consist of two images of the same size. */
    void start(const Context& context) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int count = std::min<int>(p.size, LOOKED_AT);
        const float* const rows[4] = {p.column[X1], p.column[Y1], p.column[X2], p.column[Y2]};
        float first[2] = {FLT_MIN, FLT_MIN};
        sizes[0] = sizes[1] = FLT_MIN;
        for (int k = 0; k < 4 && count > 0; ++k)
        {
            first[k / 2] = std::max(first[k / 2],
                                    ofRank(count - 1 - count / TRIMMED, rows[k], count) -
                                        ofRank(count / TRIMMED, rows[k], count));
            sizes[k / 2] = std::max(sizes[k / 2], p.upper[k] - p.lower[k]);
        }
        if (std::abs(std::log(first[1] / first[0])) < std::abs(std::log(sizes[1] / sizes[0])))
            std::copy(first, first + 2, sizes);
        lookForTargets(p);
    }

    void thresholdChanged(const Context& context) CV_OVERRIDE { lookForTargets(context.points); }

    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        if (!targets)
            return !anyShareAPoint(p, sample, m);
        const TargetLimits limits(p.threshold, sizes);
        return !anyPair(sample, m, [&](int i, int k) { return shareATarget(p, limits, i, k); });
    }

    bool mayBeGood(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return onlyRepeats(context.points, sample, context.components.minimalSolver->sampleSize());
    }

    void discount(const Context& context, const Model& model, Quality& quality) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        if (context.components.score->wholeModel())
            return;
        const InsensitivityTest insensitive(model, sizes, p.threshold);
        int seen = 0;
        for (int i = 0; i < std::min<int>(p.size, LOOKED_AT); ++i)
            seen += insensitive.holds(p.column[X1][i], p.column[Y1][i], p.column[X2][i],
                                      p.column[Y2][i]);
        if (seen < FEW)
            return;
        Arena::Scope scope(context.arena);
        DependentPoints silent(p, p.size, scope);
        for (int i = 0; i < p.size; ++i)
            if (insensitive.holds(p.column[X1][i], p.column[Y1][i], p.column[X2][i],
                                  p.column[Y2][i]))
                silent.add(i);
        silent.countOnce(context, model, quality);
    }

private:
    void lookForTargets(const Correspondences& p)
    {
        const TargetLimits limits(p.threshold, sizes);
        int shared = 0;
        for (int i = 1; i < std::min<int>(p.size, FIRST_PAIRS); ++i)
            for (int k = 0; k < i; ++k)
                shared += shareATarget(p, limits, i, k);
        targets = shared >= SHARED_PAIRS;
    }

    float sizes[2];  //!< extents of the points in the two images
    bool targets;    //!< true if many matches share points
};

}  // namespace

Ptr<Degeneracy> createSharedPoints() { return makePtr<SharedPoints>(); }

}  // namespace usacv20
}  // namespace cv
