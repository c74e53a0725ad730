// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/point_subset.hpp"
#include "problems/homography/homography.hpp"
#include "problems/two_view/share_a_point.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Refuses samples in which two matches share a point of image 1 or of image 2.

A point has one counterpart at most: of two such matches one is wrong, or they are the same match twice. Compares all
pairs of the sample. A match that is there so often that it is a tenth of all counts as one for the quality of a new
best model: any model fitted to it would have that tenth, and no sample of right matches has. */
class RepeatedPoints : public Degeneracy
{
public:
    RepeatedPoints() : searched(false) {}

    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int m = context.components.minimalSolver->sampleSize();
        return !anyPair(sample, m, [&p](int i, int k) { return shareAPoint(p, i, k); });
    }

    bool mayBeGood(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return onlyRepeats(context.points, sample, context.components.minimalSolver->sampleSize());
    }

    bool recover(const Context& context, State&, const int*, Model& model, Quality& quality) CV_OVERRIDE
    {
        const Score& score = *context.components.score;
        if (!searched)
            search(context.points);
        const int count = repetitions.size();
        if (count == 0 || score.wholeModel())
            return true;
        const double* const errors = repetitions.squaredErrors(*context.components.residual, model);
        floats.assign(errors, errors + count);
        Quality sum(0, 0);
        score.accumulate(floats.data(), count, (float)(context.points.threshold * context.points.threshold), sum);
        quality.cost += count - sum.cost;
        quality.inliers = std::max(quality.inliers - sum.inliers, 0);
        return true;
    }

private:
    //! A match that is there so often among the first points, or more often than once in so many of all, is one match.
    enum { FIRST_POINTS = 64, OFTEN = 3, TENTH = 10 };

    //! Fills `repetitions`, without the first of each.
    void search(const Correspondences& p)
    {
        searched = true;
        for (int i = 0; i < std::min<int>(p.size, FIRST_POINTS); ++i)
        {
            int same = 1;
            for (int k = 0; k < i; ++k)
                same += sameMatch(p, i, k);
            if (same == OFTEN)
                addRepetitions(p, i);
        }
    }

    void addRepetitions(const Correspondences& p, int of)
    {
        std::vector<int> found;
        for (int i = 0; i < p.size; ++i)
            if (i != of && sameMatch(p, i, of))
                found.push_back(i);
        if (((int)found.size() + 1) * TENTH <= p.size)
            return;
        for (size_t i = 0; i < found.size(); ++i)
            repetitions.add(p, found[i]);
    }

    bool searched;
    PointSubset repetitions;
    std::vector<float> floats;
};

}  // namespace

Ptr<Degeneracy> createRepeatedPoints() { return makePtr<RepeatedPoints>(); }

}  // namespace usacv20
}  // namespace cv
