// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "significance/agreement.hpp"
#include "components/repetitions.hpp"
#include "components/streams.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Minimum number of wrong matches made with each point of array 1, if there are enough points.
constexpr int PARTNERS = 4;

//! True if a column belongs to array 2: a coordinate, or the noise of the points of array 2. The
//! factors of the errors (one sigma for each match) are regarded as the noise of array 2.
bool ofPartner(const Correspondences& p, int column)
{
    const bool root1 = column >= p.columns() + 3;
    return column >= p.coordinates[0] && !root1;
}

bool hasOneArray(const Correspondences& p) { return p.coordinates[1] == 0; }

//! Replaces the coordinates of points with random ones in the box of a problem's only array.
//! @param draw different numbers give different points
//! @param rows `count` numbers for each coordinate
template <typename T>
void drawInBox(const Correspondences& p, int draw, int count, T* const* rows)
{
    Rng rng(0, streamOf(STREAM_WRONG, draw));
    for (int k = 0; k < p.columns(); ++k)
        for (int i = 0; i < count; ++i)
            rows[k][i] = (T)(p.lower[k] + (p.upper[k] - p.lower[k]) * (rng.next() / 4294967296.));
}

/** Makes wrong matches, that is, pairs the point of each match in array 1 with the point of another
match in array 2, or, if there is only one array, draws wrong points. T is float for built-in
residuals, and double for a custom residual, which has no kernels. A custom residual may depend on
the Correspondences of the run; therefore it gets the wrong matches as columns, not as other
Correspondences. */
template <typename T>
class WrongPairs
{
public:
    WrongPairs(const Residual& residual_, const Model& model_, const Correspondences& points_,
               const T* const* from, int count, double threshold, Arena::Scope& scope)
        : residual(residual_), model(model_), points(points_), columns(points.numbers()),
          limit((T)(threshold * threshold)), size(count), stride(2 * count),
          memory(scope.take<T>((columns + 1) * (size_t)stride))
    {
        for (int k = 0; k < columns; ++k)
            std::copy(from[k], from[k] + count, row(k));
    }

    //! Marks the inliers. @return their number
    int inliers(uchar* mask)
    {
        computeErrors(0);
        int sum = 0;
        for (int i = 0; i < size; ++i)
            sum += mask[i] = row(columns)[i] <= limit;  // NaN is not an inlier
        return sum;
    }

    //! Removes the matches that are marked in `repeated`, and appends a copy of array 2 to itself,
    //! so that agreeing() finds a partner for the last points of array 1, too.
    //! @return number of matches left
    int drop(const uchar* repeated)
    {
        int kept = 0;
        for (int i = 0; i < size; ++i)
            if (!repeated[i])
            {
                for (int k = 0; k < columns; ++k)
                    row(k)[kept] = row(k)[i];
                ++kept;
            }
        size = kept;
        for (int k = 0; k < columns; ++k)
            if (ofPartner(points, k))
                std::copy(row(k), row(k) + size, row(k) + size);
        return size;
    }

    //! Number of wrong matches within the threshold if each point i of array 1 is paired with point
    //! i + `partner` of array 2. If there is only one array: number of random points within the
    //! threshold; these points differ for each value of `partner`, and they overwrite the points of
    //! this object. To be called after drop().
    int agreeing(int partner)
    {
        if (hasOneArray(points))
        {
            T* rows[MAX_COLUMNS];
            for (int k = 0; k < columns; ++k)
                rows[k] = row(k);
            drawInBox(points, partner, size, rows);
            computeErrors(0);
        }
        else
            computeErrors(partner);
        const T* const errors = row(columns);
        int sum = 0;
        for (int i = 0; i < size; ++i)
            sum += errors[i] <= limit ? 1 : 0;
        return sum;
    }

private:
    T* row(int k) { return memory + (size_t)k * stride; }
    void computeErrors(int partner);

    const Residual& residual;
    const Model& model;
    const Correspondences& points;
    const int columns;
    const T limit;
    int size;
    const int stride;
    T* const memory;  //!< rows of `stride` numbers: the columns, then the errors
};

template <>
void WrongPairs<double>::computeErrors(int partner)
{
    const double* data[MAX_COLUMNS];
    for (int k = 0; k < columns; ++k)
        data[k] = row(k) + (ofPartner(points, k) ? partner : 0);
    residual.squaredErrors(model, data, size, row(columns));
}

template <>
void WrongPairs<float>::computeErrors(int partner)
{
    Correspondences view = points;
    view.size = size;
    for (int k = 0; k < columns; ++k)
        view.column[k] = row(k) + (ofPartner(points, k) ? partner : 0);
    residual.squaredErrors(view, model, 0, size, row(columns));
}

template <typename T>
Agreement count(WrongPairs<T>& wrongPairs, const Correspondences& p, int count, double threshold,
                int pairs, Arena& arena)
{
    Arena::Scope scope(arena);
    uchar *const mask = scope.take<uchar>(count), *const repeated = scope.take<uchar>(count);
    std::fill(repeated, repeated + count, (uchar)0);
    Agreement found;
    found.inliers = wrongPairs.inliers(mask);
    found.inliers -= markRepeated(p, 0, mask, count, threshold, repeated, arena);
    found.points = wrongPairs.drop(repeated);
    found.pairs = found.agreeing = 0;
    const int partners = std::min(std::max<int>(PARTNERS, pairs / std::max(found.points, 1)),
                                  found.points - 1);
    for (int partner = 1; partner <= partners; ++partner)
    {
        found.agreeing += wrongPairs.agreeing(partner);
        found.pairs += found.points;
    }
    return found;
}

}  // namespace

Agreement countAgreement(const Residual& residual, const Model& model, const Correspondences& p,
                         int size, double threshold, int pairs, Arena& arena)
{
    Arena::Scope scope(arena);
    if (!residual.kernels())
    {
        WrongPairs<double> wrongPairs(residual, model, p, p.exact, size, threshold, scope);
        return count(wrongPairs, p, size, threshold, pairs, arena);
    }
    WrongPairs<float> wrongPairs(residual, model, p, p.column, size, threshold, scope);
    return count(wrongPairs, p, size, threshold, pairs, arena);
}

int wrongErrors(const Residual& residual, const Model& model, const Correspondences& p, int count,
                float* errors, Arena& arena)
{
    Arena::Scope scope(arena);
    const bool custom = !residual.kernels(), one = hasOneArray(p);
    const int columns = p.numbers();
    double* const exact = custom || one ? scope.take<double>(count) : 0;
    double* drawn[MAX_COLUMNS];
    for (int k = 0; one && k < p.columns(); ++k)
        drawn[k] = scope.take<double>(count);
    int done = 0;
    for (int partner = 1; partner <= WRONG_PARTNERS && partner < count; ++partner)
    {
        Correspondences view = p;
        const double* moved[MAX_COLUMNS];
        view.size = count - partner;
        if (one)
            drawInBox(p, partner, view.size, drawn);
        for (int k = 0; k < columns; ++k)
        {
            const int offset = !one && ofPartner(p, k) ? partner : 0;
            view.column[k] += offset;
            moved[k] = one && k < p.columns() ? drawn[k] : p.exact[k] + offset;
        }
        if (custom || one)
        {
            residual.squaredErrors(model, moved, view.size, exact);
            std::copy(exact, exact + view.size, errors + done);
        }
        else
            residual.squaredErrors(view, model, 0, view.size, errors + done);
        done += view.size;
    }
    return done;
}

}  // namespace usacv20
}  // namespace cv
