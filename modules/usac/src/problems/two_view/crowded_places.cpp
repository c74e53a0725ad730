// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <Eigen/Cholesky>
#include "problems/share_a_point.hpp"
#include "problems/two_view/two_view.hpp"
#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Effects of halving and doubling these constants: doc/constants.md.

//! The first LOOKED_AT points are compared with each other. If there is a place, at least SEEN of
//! the others are near one of them.
constexpr int LOOKED_AT = 64, SEEN = 3;
//! The extent of the first points is computed without 1 / TRIMMED of them at each end.
constexpr int TRIMMED = 32;
//! A place has at least 1 / TENTH of all points. Even an object of only 16 pixels has fewer points
//! within the size of a place.
constexpr int TENTH = 10;
//! No more places than this can have that many points.
constexpr int MOST_PLACES = TENTH;
//! An apparent place is a distant object if an affine map of array 1 explains at least this share
//! of its scatter in array 2. Of the scatter of n points due to noise, it explains about 2 / n.
constexpr double EXPLAINED = 0.9;

//! Squared distance of two points of an array.
inline float squaredDistance(const Correspondences& p, int array, int i, int k)
{
    const int first = array ? p.coordinates[0] : 0, last = first + p.coordinates[array];
    float sum = 0;
    for (int c = first; c < last; ++c)
        sum += square(p.column[c][i] - p.column[c][k]);
    return sum;
}

/** True if an apparent place is a distant object: an affine map of array 1 predicts its points in
array 2, judged by the squared multiple correlation. */
bool isObject(const Correspondences& p, const int* members, int count)
{
    if (count < 2 * (p.coordinates[0] + 1))
        return false;
    Eigen::Vector3d mean1 = Eigen::Vector3d::Zero(), mean2 = mean1;
    const auto pointOf = [&p](int array, int i) {
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        for (int c = 0; c < p.coordinates[array]; ++c)
            point[c] = p.exact[array * p.coordinates[0] + c][i];
        return point;
    };
    for (int i = 0; i < count; ++i)
    {
        mean1 += pointOf(0, members[i]) / count;
        mean2 += pointOf(1, members[i]) / count;
    }
    Eigen::Matrix3d within = Eigen::Matrix3d::Zero(), across = within;
    double scatter = 0;
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector3d first = pointOf(0, members[i]) - mean1,
                              second = pointOf(1, members[i]) - mean2;
        within += first * first.transpose();
        across += first * second.transpose();
        scatter += second.squaredNorm();
    }
    within.diagonal().array() += 1e-12 * within.trace();  // points of a plane
    const double explained = (across.transpose() * within.ldlt().solve(across)).trace();
    return explained >= EXPLAINED * scatter;
}

/** @brief Maps and poses: matches of many points to one place (a watermark, a blinking light, a
dead pixel), however noisy, are no independent evidence.

A map that shrinks everything to that place, or a camera far away, fits them all, wherever their
points in array 1 are. Therefore
- samples are rejected in which two matches to a place are far apart in array 1, see TargetLimits;
- in the quality of a new so-far-the-best model, the inliers of each place count as one. The model
is kept, but no longer beats models with real support. The map of a small object keeps most of its
quality, because it does not shrink the object to one place.

Matches from one place of array 1 to many points of array 2 need no check, because no map fits them.
Places are searched for once, with the inlier threshold: with the wider reach of some scores
(Params::reach), a small object would look like one place. The quality is not changed for scores
that are no sum over the points. */
class CrowdedPlaces : public Degeneracy
{
public:
    CrowdedPlaces() : places(0), farApart(0), placeOf(0), members(0) { ends[0] = 0; }

    void start(const Context& context) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        places = 0;
        if (p.size <= SEEN || p.coordinates[1] == 0)
            return;
        int seen[LOOKED_AT];
        const int count = std::min<int>(p.size, LOOKED_AT);
        const double threshold = context.inlierThreshold();
        look(p, (float)square(NEAR_THRESHOLDS * threshold), -1, count, seen);
        if (*std::max_element(seen, seen + count) < SEEN)
            return;
        float sizes[2] = {FLT_MIN, FLT_MIN};
        for (int k = 0; k < p.columns(); ++k)
        {
            float& size = sizes[k >= p.coordinates[0]];
            size = std::max(size, std::max(p.upper[k] - p.lower[k], extent(p.column[k], count)));
        }
        const TargetLimits limits(threshold, sizes);
        farApart = limits.far[0];
        look(p, limits.near[1], farApart, count, seen);
        for (int most; places < MOST_PLACES &&
                       seen[most = (int)(std::max_element(seen, seen + count) - seen)] >= SEEN;)
        {
            addPlace(context, most, limits.near[1]);
            seen[most] = 0;
            for (int i = 0; i < count && places > 0; ++i)
                seen[i] = placeOf[i] ? 0 : seen[i];
        }
    }

    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const auto sharePlace = [&](int i, int k) {
            return placeOf[i] && placeOf[i] == placeOf[k] && squaredDistance(p, 0, i, k) > farApart;
        };
        return places == 0 ||
               !anyPair(sample, context.components.minimalSolver->sampleSize(), sharePlace);
    }

    void discount(const Context& context, const Model& model, Quality& quality) CV_OVERRIDE
    {
        if (context.components.score->wholeModel())
            return;
        for (int k = 0; k < places; ++k)
        {
            Arena::Scope scope(context.arena);
            PointSubset place(context.points, ends[k + 1] - ends[k], scope);
            for (int i = ends[k]; i < ends[k + 1]; ++i)
                place.add(members[i]);
            countOnce(context, 1, place, model, quality);
        }
    }

private:
    //! Extent of the first points without the outermost ones. (If nearly all points are at one
    //! place, the box Correspondences::lower, upper covers no more than that place.)
    static float extent(const float* column, int count)
    {
        float values[LOOKED_AT];
        std::copy(column, column + count, values);
        std::sort(values, values + count);
        return values[count - 1 - count / TRIMMED] - values[count / TRIMMED];
    }

    //! Counts for each of the first points how many others are near it in array 2 but far from it
    //! in array 1; `near` and `far` are squared distances.
    static void look(const Correspondences& p, float near, float far, int count, int* seen)
    {
        std::fill(seen, seen + count, 0);
        for (int i = 1; i < count; ++i)
        {
            float squares[LOOKED_AT] = {0};
            for (int c = p.coordinates[0]; c < p.columns(); ++c)
            {
                const float* const column = p.column[c];
                const float value = column[i];
                for (int k = 0; k < i; ++k)
                    squares[k] += square(column[k] - value);
            }
            for (int k = 0; k < i; ++k)
                if (squares[k] <= near && squaredDistance(p, 0, i, k) > far)
                {
                    ++seen[i];
                    ++seen[k];
                }
        }
    }

    //! Adds the points near `center` as a place if there are enough of them. No point is in two
    //! places.
    void addPlace(const Context& context, int center, float near)
    {
        const Correspondences& p = context.points;
        if (places == 0)
        {
            placeOf = context.arena.take<uchar>(p.size);
            members = context.arena.take<int>(p.size);
            std::fill(placeOf, placeOf + p.size, (uchar)0);
        }
        int end = ends[places];
        for (int i = 0; i < p.size; ++i)
            if (!placeOf[i] && squaredDistance(p, 1, i, center) <= near)
                members[end++] = i;
        const int count = end - ends[places];
        if (count * TENTH < p.size || isObject(p, members + ends[places], count))
            return;
        for (int i = ends[places]; i < end; ++i)
            placeOf[members[i]] = (uchar)(places + 1);
        ends[++places] = end;
    }

    int places;
    float farApart;             //!< squared distance in array 1
    uchar* placeOf;             //!< place of each point, from 1 on; 0: none
    int* members;               //!< points of the places, one place after the other
    int ends[MOST_PLACES + 1];  //!< place k + 1 is ends[k] .. ends[k + 1] - 1 of `members`
};

}  // namespace

Ptr<Degeneracy> createCrowdedPlaces() { return makePtr<CrowdedPlaces>(); }

}  // namespace usacv20
}  // namespace cv
