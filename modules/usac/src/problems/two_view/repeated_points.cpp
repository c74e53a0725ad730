// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/share_a_point.hpp"
#include "problems/two_view/two_view.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Rejects samples in which two matches share a point of array 1 or of array 2.

A point has at most one counterpart: if two matches share a point, at least one of them is wrong, or
they are the same match twice. */
class RepeatedPoints : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        return !anyShareAPoint(p, sample, m);
    }

    bool mayBeGood(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return onlyRepeats(context.points, sample, context.components.minimalSolver->sampleSize());
    }
};

}  // namespace

Ptr<Degeneracy> createRepeatedPoints() { return makePtr<RepeatedPoints>(); }

void createChecksOfMaps(int flags, const String& problem,
                        std::vector<Ptr<Degeneracy>>& degeneracies)
{
    const int all = DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC | DEGENERACY_REPEATED;
    if ((flags & DEGENERACY_DEGENSAC) && flags != all)
        CV_Error_(
            Error::StsBadArg,
            ("degeneracy: %d contains DEGENERACY_DEGENSAC, which is for F and E; for the problem "
             "%s, use DEGENERACY_REPEATED, 0, or the default %d (all checks for this problem)",
             flags, problem.c_str(), all));
    if (flags & DEGENERACY_REPEATED)
    {
        degeneracies.push_back(createRepeatedPoints());
        degeneracies.push_back(createCrowdedPlaces());
    }
}

}  // namespace usacv20
}  // namespace cv
