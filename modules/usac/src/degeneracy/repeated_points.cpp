// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "degeneracy/degeneracy.hpp"
#include "degeneracy/share_a_point.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Refuses samples in which two matches share a point of image 1 or of image 2.

A point has one counterpart at most: of two such matches one is wrong, or they are the same match twice. Without this, many
matches of one target (repeated patterns, matching without cross-check) win by an F whose epipole is the target, which fits them
all. Compares all pairs of the sample. */
class RepeatedPoints : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        for (int i = 1; i < m; ++i)
            for (int k = 0; k < i; ++k)
                if (shareAPoint(p, sample[i], sample[k]))
                    return false;
        return true;
    }

    bool mayBeGood(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return onlyRepeats(context.points, sample, context.components.minimalSolver->sampleSize());
    }
};

} // namespace

Ptr<Degeneracy> createRepeatedPoints()
{
    return makePtr<RepeatedPoints>();
}

} // namespace usacv20
} // namespace cv
