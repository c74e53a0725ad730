// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/two_view.hpp"
#include "scoring/counted_once.hpp"
#include "problems/share_a_point.hpp"
#include "scoring/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Half and double of these, doc/constants.md: on the lists no run but one or two of E differs; what
// scenes of matches to one or two points tell is said here. Where nothing is said they are the
// same.

//! Fewer than so many of the first points are no matter; all of few points are looked at. FEW 16:
//! 14 of 704 F are wrong for 1 (23 if the inliers were always left as they are), 11 of 720 E for 8.
constexpr int LOOKED_AT = 64, FEW = 8;
//! Many matches share points if so many pairs of the first points do, 3 %. With two targets of a
//! third of the matches each a fifth of the pairs do. 64 points, and still 3 % of the pairs: 5 F
//! are wrong for 1.
constexpr int FIRST_PAIRS = 32, SHARED_PAIRS = 16;
//! One in so many of the first points is left out at each end for the size of the image.
constexpr int TRIMMED = 10;

//! Thresholds: what the error is, at most, of a match that is an inlier whatever one of its ends
//! is. At the thresholds of images of some hundred pixels #FAR_APART says more. 20: the same for E
//! of OpenCV's tests.
constexpr double ANYWHERE = 60;

/** Tells whether a match is an inlier whatever one of its ends is, see SharedPoints. `sizes`: of
the images. */
class OneEnd
{
public:
    OneEnd(const Model& F, const float* sizes, double threshold)
        : most1((float)square(std::max<double>(FAR_APART / sizes[1], 1 / (ANYWHERE * threshold)) *
                              sizes[0])),
          most2((float)square(std::max<double>(FAR_APART / sizes[0], 1 / (ANYWHERE * threshold)) *
                              sizes[1]))
    {
        toFloat(F, f);
    }

    bool counts(float x1, float y1, float x2, float y2) const
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

/** @brief F, E: matches of many points to one, however noisy, are no independent evidence.

Matches of one target (repeated patterns, matching without cross-check) are fitted by every epipolar
geometry whose epipole is the target, whatever their other ends are; those of two targets, or of
points on a line, by an F of nearly rank 1, to which all epipolar lines are that line. So

- samples are refused in which two matches share a point; if many matches do, also but for the noise
(shareATarget: where they are few, two of them may be right ones that one camera sees close
together);
- of a new best model, the inliers that would be inliers whatever their other ends were count as
one. Quality is changed by the rest of them. The model stays, as there may be no better one; but it
does not beat those with real support any more.

Which inliers these are: where the line F^T x2 has next to no normal (its first two entries), a
shift of x2 within the noise turns it anywhere, and x1 tells nothing. The lengths of the normals of
F x1 and F^T x2 are as the distances of neighboring epipolar lines in the two images, which in right
geometries are as the local scales; a ratio of #FAR_APART times that of the images' sizes is taken
for too much, if it is enough for #ANYWHERE thresholds to hold the other end wherever it is in its
image. (With a camera among the points the scale in one image may differ by hundreds.) Points beside
the epipole of a camera that moves forwards are beside both epipoles, and pass.

The first #LOOKED_AT points tell whether it is worth while to look at the others. Qualities that are
no sum over the points are left. */
class SharedPoints : public Degeneracy
{
public:
    SharedPoints() : targets(false) { sizes[0] = sizes[1] = FLT_MIN; }

    /** How large the images are, as far as there are points: by the frame of the points, which some
    that are far out do not change, or by the first points, of which the matches of one target are
    not all; the images are most often of one size. */
    void start(const Context& context) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int count = std::min<int>(p.size, LOOKED_AT);
        const float* const rows[4] = {p.column[X1], p.column[Y1], p.column[X2], p.column[Y2]};
        float first[2] = {FLT_MIN, FLT_MIN};
        sizes[0] = sizes[1] = FLT_MIN;
        for (int k = 0; k < 4 && count > 0; ++k)
        {
            float values[LOOKED_AT];
            std::copy(rows[k], rows[k] + count, values);
            std::sort(values, values + count);
            first[k / 2] = std::max(first[k / 2],
                                    values[count - 1 - count / TRIMMED] - values[count / TRIMMED]);
            sizes[k / 2] = std::max(sizes[k / 2], p.upper[k] - p.lower[k]);
        }
        if (std::abs(std::log(first[1] / first[0])) < std::abs(std::log(sizes[1] / sizes[0])))
            std::copy(first, first + 2, sizes);
        const TargetLimits limits(p.threshold, sizes);
        int shared = 0;
        for (int i = 1; i < std::min<int>(p.size, FIRST_PAIRS); ++i)
            for (int k = 0; k < i; ++k)
                shared += shareATarget(p, limits, i, k);
        targets = shared >= SHARED_PAIRS;
    }

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

    bool recover(const Context& context, State&, const int*, Model& model,
                 Quality& quality) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        if (context.components.score->wholeModel())
            return true;
        const OneEnd one(model, sizes, p.threshold);
        int seen = 0;
        for (int i = 0; i < std::min<int>(p.size, LOOKED_AT); ++i)
            seen += one.counts(p.column[X1][i], p.column[Y1][i], p.column[X2][i], p.column[Y2][i]);
        if (seen < FEW)
            return true;
        Arena::Scope scope(context.arena);
        PointSubset silent(p, p.size, scope);
        for (int i = 0; i < p.size; ++i)
            if (one.counts(p.column[X1][i], p.column[Y1][i], p.column[X2][i], p.column[Y2][i]))
                silent.add(i);
        countOnce(context, 1, silent, model, quality);
        return true;
    }

private:
    float sizes[2];  //!< of the images
    bool targets;    //!< many matches share points
};

}  // namespace

Ptr<Degeneracy> createSharedPoints() { return makePtr<SharedPoints>(); }

}  // namespace usacv20
}  // namespace cv
