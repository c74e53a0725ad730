// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/share_a_point.hpp"
#include "problems/two_view/two_view.hpp"
#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! All occurrences of a match count as a single inlier if at least OFTEN of these occurrences are
//! among the first FIRST_POINTS matches, a random subset, and if all occurrences make up more than
//! 1 / COMMON of all matches. See doc/constants.md.
constexpr int FIRST_POINTS = 64, OFTEN = 3, COMMON = 10;

/** @brief Rejects samples in which two matches share a point of array 1 or of array 2.

A point has at most one counterpart: if two matches share a point, at least one of them is wrong, or
they are the same match twice. If the occurrences of a match make up more than a tenth of all
matches, they count as a single inlier in the quality of each new best model, because every model
fitted to this match has all these occurrences as inliers. */
class RepeatedPoints : public Degeneracy
{
public:
    RepeatedPoints() : searched(false), repetitions(0), count(0) {}

    void start(const Context&) CV_OVERRIDE { searched = false; }

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

    void discount(const Context& context, const Model& model, Quality& quality) CV_OVERRIDE
    {
        if (!searched)
            search(context);
        if (count == 0 || context.components.score->wholeModel())
            return;
        Arena::Scope scope(context.arena);
        PointSubset subset(context.points, count, scope);
        for (int i = 0; i < count; ++i)
            subset.add(repetitions[i]);
        countOnce(context, 0, subset, model, quality);
    }

private:
    //! Finds the repetitions of frequent matches, that is, all occurrences of each such match
    //! except one.
    void search(const Context& context)
    {
        const Correspondences& p = context.points;
        searched = true;
        count = 0;
        repetitions = 0;
        for (int i = 0; i < std::min<int>(p.size, FIRST_POINTS); ++i)
        {
            const float* const column = p.column[0];
            int equal = 1, same = 1;
            for (int k = 0; k < i; ++k)  // fast preliminary test, without branches
                equal += column[k] == column[i];
            if (equal < OFTEN)
                continue;
            for (int k = 0; k < i; ++k)
                same += sameMatch(p, i, k);
            if (same == OFTEN)
                addRepetitions(context, i);
        }
    }

    //! Adds the repetitions of the match `of` if its occurrences are more than 1 / COMMON of all
    //! matches. A match cannot repeat two different matches, so that Correspondences::size elements
    //! are enough for `repetitions`.
    void addRepetitions(const Context& context, int of)
    {
        const Correspondences& p = context.points;
        if (!repetitions)
            repetitions = context.arena.take<int>(p.size);
        int found = count;
        for (int i = 0; i < p.size; ++i)
            if (i != of && sameMatch(p, i, of))
                repetitions[found++] = i;
        if ((found - count + 1) * COMMON > p.size)
            count = found;
    }

    bool searched;
    int* repetitions;
    int count;  //!< number of elements of `repetitions`
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
