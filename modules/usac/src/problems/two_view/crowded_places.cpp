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

// In this file, a place is a small region of array 2, at most a few thresholds wide, to which many
// different points of array 1 are matched. Arrays 1 and 2 are the caller's two arrays of points; in
// the code, they have the indices 0 and 1.

//! The first FIRST_SEEN points, a random subset, are compared with each other. One of these points
//! can be the center of a place if at least SEEN of the other points are near it in array 2 and far
//! from it in array 1.
constexpr int FIRST_SEEN = 64, SEEN = 3;
//! The extent of the first points is computed without the smallest and the largest 1 / TRIMMED_PART
//! of their coordinates.
constexpr int TRIMMED_PART = 32;
//! A place has at least 1 / TENTH of all points. Even if all points lie on an object whose image is
//! only 16 pixels wide, a region of the size of a place contains a smaller fraction of them.
constexpr int TENTH = 10;
//! Maximum number of places. It follows from TENTH, because no point is in two places.
constexpr int MOST_PLACES = TENTH;
//! An apparent place is a distant object if an affine map from array 1 explains at least this
//! fraction of the scatter of the place's points in array 2. If the scatter of n points is only
//! noise, the map explains a fraction of about d / n, where d is the number of coordinates in array
//! 1.
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

/** True if an apparent place is a distant object, so that an affine map from array 1 predicts the
points of the place in array 2. The criterion is the squared multiple correlation. False if there
are too few points for this test. */
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
    within.diagonal().array() += 1e-12 * within.trace();  // the matrix can be singular
    const double explained = (across.transpose() * within.ldlt().solve(across)).trace();
    return explained >= EXPLAINED * scatter;
}

/** @brief Check for maps and poses: matches of many points to one place (a watermark, a blinking
light, a dead pixel) are not independent evidence, even if they are noisy.

A map that shrinks everything to this place, or a camera far away, fits all these matches, wherever
their points in array 1 are. Therefore
- samples are rejected in which two matches to the same place are far apart in array 1, see
TargetLimits;
- in the quality of each new best model, the inliers of each place count as a single inlier. The
model is kept, but its score is no longer better than that of correct models. The map of a small
object keeps most of its quality, because this map does not shrink the object to one place.

Matches from one place of array 1 to many points of array 2 need no check, because no map fits them.
Places are searched for at the start, and again when the inlier threshold has changed. The larger
threshold that some scores use (Params::reach) is not suitable for this search, because a small
object would look like one place. The quality is not changed for scores that are not a sum over the
points. */
class CrowdedPlaces : public Degeneracy
{
public:
    CrowdedPlaces() : places(0), farApart(0), placeOf(0) {}

    void start(const Context& context) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const double threshold = context.inlierThreshold();
        places = 0;
        if (p.size <= SEEN || p.coordinates[1] == 0)
            return;
        const int count = std::min<int>(p.size, FIRST_SEEN);
        if (mostNear(p, (float)square(NEAR_THRESHOLDS * threshold), count) < SEEN)
            return;
        int seen[FIRST_SEEN];
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
            for (int i = 0; i < count; ++i)
                if ((places > 0 && placeOf[i]) || squaredDistance(p, 1, i, most) == 0)
                    seen[i] = 0;
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

    void thresholdChanged(const Context& context) CV_OVERRIDE { start(context); }

    void discount(const Context& context, const Model& model, Quality& quality) CV_OVERRIDE
    {
        if (context.components.score->wholeModel())
            return;
        for (int k = 0; k < places; ++k)
            pointsOf[k]->countOnce(context, model, quality);
    }

private:
    //! Extent of the first points in one column, without the outermost points. It is needed because
    //! the box Correspondences::lower, upper covers only the place if nearly all points are in one
    //! place.
    static float extent(const float* column, int count)
    {
        float values[FIRST_SEEN];
        std::copy(column, column + count, values);
        std::sort(values, values + count);
        return values[count - 1 - count / TRIMMED_PART] - values[count / TRIMMED_PART];
    }

    //! Largest number of the first `count` points that are near one of the other points among them
    //! in array 2. All loops have the same length, so that compilers vectorize them.
    //! @param near largest squared distance of near points
    static int mostNear(const Correspondences& p, float near, int count)
    {
        const int first = p.coordinates[0], columns = p.coordinates[1];
        float values[MAX_COLUMNS][FIRST_SEEN];
        for (int c = 0; c < columns; ++c)
        {
            std::copy(p.column[first + c], p.column[first + c] + count, values[c]);
            std::fill(values[c] + count, values[c] + FIRST_SEEN,
                      std::numeric_limits<float>::quiet_NaN());  // near no point
        }
        int most = 0;
        for (int i = 0; i < count; ++i)
        {
            float squares[FIRST_SEEN] = {0};
            for (int c = 0; c < columns; ++c)
            {
                const float value = values[c][i];
                for (int k = 0; k < FIRST_SEEN; ++k)
                    squares[k] += square(values[c][k] - value);
            }
            int found = -1;  // the point itself does not count
            for (int k = 0; k < FIRST_SEEN; ++k)
                found += squares[k] <= near;
            most = std::max(most, found);
        }
        return most;
    }

    //! Counts for each of the first `count` points how many of the other points among them are at
    //! most `near` away in array 2 but more than `far` away in array 1. Both limits are squared
    //! distances.
    static void look(const Correspondences& p, float near, float far, int count, int* seen)
    {
        std::fill(seen, seen + count, 0);
        for (int i = 1; i < count; ++i)
            for (int k = 0; k < i; ++k)
                if (squaredDistance(p, 1, i, k) <= near && squaredDistance(p, 0, i, k) > far)
                {
                    ++seen[i];
                    ++seen[k];
                }
    }

    //! Adds the points near the point `center` as a place if there are enough of these points and
    //! they are not a distant object. No point is in two places.
    void addPlace(const Context& context, int center, float near)
    {
        const Correspondences& p = context.points;
        if (places == 0)
        {
            placeOf = context.arena.take<uchar>(p.size);
            std::fill(placeOf, placeOf + p.size, (uchar)0);
        }
        Arena::Scope scope(context.arena);
        int* const members = scope.take<int>(p.size);
        int count = 0;
        for (int i = 0; i < p.size; ++i)
            if (!placeOf[i] && squaredDistance(p, 1, i, center) <= near)
                members[count++] = i;
        if (count * TENTH < p.size || isObject(p, members, count))
            return;
        pointsOf[places] = new (context.arena.take<DependentPoints>(1))
            DependentPoints(p, count, context.arena);
        for (int i = 0; i < count; ++i)
        {
            pointsOf[places]->add(members[i]);
            placeOf[members[i]] = (uchar)(places + 1);
        }
        ++places;
    }

    int places;
    float farApart;  //!< points of array 1 at a larger squared distance are far apart
    uchar* placeOf;  //!< number of the place of each point, from 1 on; 0: no place
    DependentPoints* pointsOf[MOST_PLACES];
};

}  // namespace

Ptr<Degeneracy> createCrowdedPlaces() { return makePtr<CrowdedPlaces>(); }

}  // namespace usacv20
}  // namespace cv
