// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include <Eigen/Cholesky>
#include "problems/share_a_point.hpp"
#include "problems/two_view/two_view.hpp"
#include "scoring/counted_once.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Half and double of these: doc/constants.md.

//! Points that are looked at first, and how many of them, at least, are at a place beside the one
//! it is seen from.
constexpr int LOOKED_AT = 64, SEEN = 3;
//! One in so many of the first points is left out at each end for the extent.
constexpr int TRIMMED = 32;
//! A place has at least one in so many of all points. An object as small as 16 pixels has fewer in
//! any of its places.
constexpr int TENTH = 10;
//! Places with that many points there are no more.
constexpr int MOST_PLACES = TENTH;
//! Of the scatter of a place in array 2 an affine map of array 1 explains this part at least if the
//! place is a distant object. Of a jitter it explains some 2 / n with n points.
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

/** Is what seems to be one place a distant object, whose points are where an affine map of array 1
has them? By the squared multiple correlation. */
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

A map that shrinks everything to that place, or a camera far away, fits them all, whatever their
other ends are. So

- samples are refused in which two matches of a place are far from each other in array 1, see
  TargetLimits;
- of a new best model, the inliers of each place count once. The model stays, but it does not beat
those with real support any more. The map of a small object keeps most of its quality, as it does
not shrink it to one place.

The other way, from one place of array 1 to many of array 2, nothing fits. Places are looked for
once, with the threshold of the inliers: a wide reach takes a small object for one place. Qualities
that are no sum over the points are left. */
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

    bool recover(const Context& context, State&, const int*, Model& model,
                 Quality& quality) CV_OVERRIDE
    {
        if (context.components.score->wholeModel())
            return true;
        for (int k = 0; k < places; ++k)
        {
            Arena::Scope scope(context.arena);
            PointSubset place(context.points, ends[k + 1] - ends[k], scope);
            for (int i = ends[k]; i < ends[k + 1]; ++i)
                place.add(members[i]);
            countOnce(context, 1, place, model, quality);
        }
        return true;
    }

private:
    //! Of the first points, but for those that are far out. (Where nearly all points are at one
    //! place the frame has no more than that.)
    static float extent(const float* column, int count)
    {
        float values[LOOKED_AT];
        std::copy(column, column + count, values);
        std::sort(values, values + count);
        return values[count - 1 - count / TRIMMED] - values[count / TRIMMED];
    }

    //! How many of the first points are near each of them in array 2, but not in array 1; squared
    //! distances.
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

    //! The points near one, if they are that many. No point is of two places.
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
    uchar* placeOf;             //!< of each point, from 1 on; 0: none
    int* members;               //!< points of each place in turn
    int ends[MOST_PLACES + 1];  //!< of their lists, from 0 on
};

}  // namespace

Ptr<Degeneracy> createCrowdedPlaces() { return makePtr<CrowdedPlaces>(); }

}  // namespace usacv20
}  // namespace cv
