// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include "problems/fundamental/plane_parallax.hpp"
#include "problems/kernels.hpp"
#include "components/sample_statistics.hpp"
#include "numeric/bits.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The line of a match is divided into bins, the possible positions of the epipole. The bins of the
//! match's points x2 and H x1, and up to NEAR bins on either side of them, do not count: an epipole
//! at x2 fits the match whatever its x1 is, and an epipole at H x1 fits it whatever its x2 is, so
//! that the match is no evidence for these epipoles.
constexpr int NEAR = 2;

//! Assumed fraction of the correct matches whose lines lead to the epipole despite noise.
constexpr double GOOD_LINES = 0.5;
//! An epipole is fitted only if the number of its votes is at least this fraction of the number of
//! inliers that the best model has among the voters (the matches off the plane), or of the wanted
//! number if this is larger. The fraction is below 1 because a model with fewer inliers can have a
//! lower cost.
constexpr double WORTH_A_FIT = 0.8;
//! A fit continues after two steps if its cost over the voters exceeds the lowest such cost by at
//! most GOES_ON. A fitted epipole is scored over all points if the excess is at most WORTH_RATING,
//! because the points on the plane decide between similar epipoles. An outlier costs 1.
constexpr double GOES_ON = 8, WORTH_RATING = 3;
//! Each step of a fit uses voters within this many thresholds. The first steps have wider limits,
//! because a fit starts at the middle of a range of bins, which can be inaccurate. After the first
//! two steps, the fit ends when a step lowers the cost by at most SETTLED (an outlier costs 1).
constexpr double SETTLED = 0.05;
constexpr double WIDTHS[] = {2, 2, 1.5, 1, 1, 1};
//! Two epipoles (as unit vectors) count as the same if the squared sine of the angle between them
//! is below this value: a distance of about two to four bins.
constexpr double SAME_EPIPOLE = 1e-3;

//! The unit vector at the middle of the range of bins first .. last on the line through the
//! orthonormal vectors u and v; the inverse of placeOf().
Vec3d middleOf(int first, int last, const Vec3d& u, const Vec3d& v)
{
    const double place = 2. * (first + last + 1) / ARCS_BINS - 1;
    const Vec3d e = place <= 1 ? u + v * place : u * (2 - place) + v;
    return e * (1 / norm(e));
}

bool sameEpipole(const Vec3d& a, const Vec3d& b)
{
    const double cosine = a.dot(b);
    return 1 - cosine * cosine < SAME_EPIPOLE;
}

//! Computes two orthonormal vectors that are orthogonal to n, which is not zero.
void lineBasis(const Vec3d& n, Vec3d& u, Vec3d& v)
{
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(n[k]) < std::abs(n[least]))
            least = k;
    Vec3d axis(0, 0, 0);
    axis[least] = 1;
    u = n.cross(axis);
    u *= 1 / norm(u);
    v = n.cross(u);
    v *= 1 / norm(v);
}

//! Computes the coefficients of the six entries of the upper triangle of a symmetric matrix G in
//! a^T G b, row by row.
template <typename T>
void formWeights(const Vec3d& a, const Vec3d& b, T* weights)
{
    for (int k = 0; k < 3; ++k)
        for (int j = k; j < 3; ++j)
            *weights++ = (T)(k == j ? a[k] * b[k] : a[k] * b[j] + a[j] * b[k]);
}

/** Finds the first range of adjacent bins that are covered by the largest number of arcs.
@param begins, ends numbers of arcs that begin in each bin, and that end in the bin before it; an
arc that passes the end of the line also begins in bin 0
@param own two bins that do not count, together with the bins near them, see NEAR
@param first, last output: the first and the last of the bins found
@return the number of arcs that cover these bins */
int densest(const int* begins, const int* ends, const int* own, int& first, int& last)
{
    int votes[ARCS_BINS];
    for (int k = 0, sum = 0; k < ARCS_BINS; ++k)
        votes[k] = sum += begins[k] - ends[k];
    for (int i = 0; i < 2; ++i)
        for (int k = own[i] - NEAR; k <= own[i] + NEAR; ++k)
            votes[(k + ARCS_BINS) % ARCS_BINS] = 0;  // the line is closed
    int most = 0;
    for (int k = 0; k < ARCS_BINS; ++k)
        most = std::max(most, votes[k]);
    first = last = (int)(std::find(votes, votes + ARCS_BINS, most) - votes);
    while (last + 1 < ARCS_BINS && votes[last + 1] == most)
        ++last;
    return most;
}

//! Computes the eigenvector `e` of the smallest eigenvalue of a positive semidefinite matrix by
//! inverse iteration, which starts from the given `e`. False if the rank of the matrix is below 2,
//! so that the eigenvector is not unique, or if the matrix is not finite.
bool smallestEigenvector(const Matx33d& M, Vec3d& e)
{
    enum { STEPS = 4 };
    const Vec3d a(M(0, 0), M(0, 1), M(0, 2)), b(M(1, 0), M(1, 1), M(1, 2)),
        c(M(2, 0), M(2, 1), M(2, 2));
    const Vec3d adjugate[3] = {b.cross(c), c.cross(a), a.cross(b)};
    for (int step = 0; step < STEPS; ++step)
    {
        const Vec3d image(adjugate[0].dot(e), adjugate[1].dot(e), adjugate[2].dot(e));
        const double length = norm(image);
        if (!(length > 0 && length <= DBL_MAX))
            return false;
        e = image * (1 / length);
    }
    return true;
}

}  // namespace

PlaneParallax::PlaneParallax()
    : H(Matx33d::zeros()), limit(0), numbers(0), terms(0), stride(0), next(0), fitted(0)
{}

/* With y = H x1 and h1, h2 the first two columns of H, the squared Sampson error of F = [e]x H has
the numerator (e n)^2, where e n is the scalar product of e with n, the cross product of y and x2.
Its denominator, the sum of the squares of the first two entries of F x1 and of F^T x2, is the sum
of the squared scalar products of e with four vectors: (0, y3, -y2), (-y3, 0, y1), and the cross
products of h1 and h2 with x2. G is the matrix of this quadratic form times the squared threshold:
the error is within the threshold if (e n)^2 <= e^T G e.
*/
void PlaneParallax::setPlane(const Context& context, const int* offPlane, int count,
                             const Matx33d& homography)
{
    const Correspondences& points = context.points;
    H = ofUnitNorm(homography);
    limit = context.inlierThreshold() * context.inlierThreshold();
    voters.gather(points, offPlane, count);
    stride = (size() + ARCS_BLOCK - 1) / ARCS_BLOCK * ARCS_BLOCK;
    if (!numbers)
    {
        numbers = context.arena.take<float>((size_t)ARCS_ROWS * MAX_POINTS);
        terms = context.arena.take<Terms>(MAX_POINTS);
    }
    for (int k = 0; k < ARCS_ROWS; ++k)
        std::fill(numbers + (size_t)k * stride + size(), numbers + (size_t)(k + 1) * stride, 0.f);
    best = Quality();
    lastFit = Vec3d(0, 0, 0);
    next = fitted = 0;
    const Correspondences& p = voters.view();
    const Vec3d h1(H(0, 0), H(1, 0), H(2, 0)), h2(H(0, 1), H(1, 1), H(2, 1));
    for (int i = 0; i < p.size; ++i)
    {
        const Vec3d x2(p.column[X2][i], p.column[Y2][i], 1),
            y = H * Vec3d(p.column[X1][i], p.column[Y1][i], 1), n = y.cross(x2);
        const Vec3d forms[4] = {Vec3d(0, y[2], -y[1]), Vec3d(-y[2], 0, y[0]), h1.cross(x2),
                                h2.cross(x2)};
        for (int k = 0; k < 3; ++k)
            numbers[(size_t)(N0 + k) * stride + i] = (float)n[k];
        for (int k = 0, at = 0; k < 3; ++k)
            for (int j = k; j < 3; ++j, ++at)
            {
                double sum = 0;
                for (int f = 0; f < 4; ++f)
                    sum += forms[f][k] * forms[f][j];
                numbers[(size_t)(G00 + at) * stride + i] = (float)(sum * limit);
                terms[i].numerator[at] = n[k] * n[j];
                terms[i].denominator[at] = sum;
            }
    }
}

int PlaneParallax::linesNeeded(double failure, double wanted) const
{
    const double inliers = std::max(std::max<double>(best.inliers, wanted), 2.0);
    return std::min(size(),
                    samplesNeeded(GOOD_LINES * inliers / std::max(size(), 1), std::log(failure)));
}

bool PlaneParallax::search(const Context& context, double failure, double wanted, Model& model,
                           Quality& quality)
{
    const Quality before = quality, own = support(model);
    if (own.betterThan(best))
        best = own;
    for (int needed = linesNeeded(failure, wanted); next < needed; ++next)
    {
        Vec3d e;
        const int votes = vote(next, e) + 1;  // includes the vote of the match itself
        if (votes < 2 || votes < WORTH_A_FIT * std::max<double>(best.inliers, wanted))
            continue;
        if (sameEpipole(e, lastFit))
            continue;
        refine(context, e, model, quality);
        needed = linesNeeded(failure, wanted);
    }
    return quality.betterThan(before);
}

//! Finds the epipole on the line of one voter that the largest number of other voters agrees with.
//! @return the number of these other voters
int PlaneParallax::vote(int line, Vec3d& epipole) const
{
    const Correspondences& p = voters.view();
    const Vec3d n(number(N0)[line], number(N1)[line], number(N2)[line]);
    if (!(norm(n) > 0))
        return 0;
    Vec3d u, v;
    lineBasis(n, u, v);
    float weights[ARCS_WEIGHTS];
    for (int k = 0; k < 3; ++k)
    {
        weights[k] = (float)u[k];
        weights[3 + k] = (float)v[k];
    }
    formWeights(u, u, weights + 6);
    formWeights(u, v, weights + 12);
    formWeights(v, v, weights + 18);
    int begins[ARCS_BINS] = {0}, ends[ARCS_BINS + 1] = {0}, from[MAX_POINTS], to[MAX_POINTS];
    kernels().arcs(numbers, stride, weights, from, to);
    int passing = 0;  // number of arcs that pass the end of the line
    for (int k = 0; k < p.size; ++k)
    {
        ++begins[from[k]];
        ++ends[to[k] + 1];
        passing += from[k] > to[k] + 1;
    }
    begins[0] += passing;
    const Vec3d x2(p.column[X2][line], p.column[Y2][line], 1),
        y = H * Vec3d(p.column[X1][line], p.column[Y1][line], 1);
    const int own[2] = {binOf(placeOf((float)x2.dot(v), (float)x2.dot(u))),
                        binOf(placeOf((float)y.dot(v), (float)y.dot(u)))};
    int first = 0, last = -1;
    const int votes = densest(begins, ends, own, first, last);
    if (votes > 0)
        epipole = middleOf(first, last, u, v);
    return votes;
}

//! Fits an epipole to the voters within decreasing multiples of the threshold. The fit with the
//! lowest cost over the voters is scored over all points and can replace the model.
void PlaneParallax::refine(const Context& context, Vec3d e, Model& model, Quality& quality)
{
    Matx33d F = crossMatrix(e) * H, candidate = F;
    Quality lowest;
    const size_t steps = sizeof(WIDTHS) / sizeof(WIDTHS[0]);
    for (size_t step = 0;
         step < steps && fit(F, WIDTHS[step], step < 2 ? (int)FIRST_FIT : MAX_POINTS, e); ++step)
    {
        F = crossMatrix(e) * H;
        const Quality here = support(F);
        if (step == 1)
        {
            if (here.cost > best.cost + GOES_ON)
                return;
            lastFit = e;
            ++fitted;
        }
        const bool settled = step > 1 && here.cost >= lowest.cost - SETTLED;
        if (here.betterThan(lowest))
        {
            lowest = here;
            candidate = F;
        }
        if (settled)
            break;
    }
    if (!(lowest.cost <= best.cost + WORTH_RATING))
        return;
    if (lowest.betterThan(best))
        best = lowest;
    const Quality whole = context.rate(candidate, quality.cost);
    if (!whole.betterThan(quality))
        return;
    model = ofUnitNorm(candidate);
    quality = whole;
}

//! Least squares over at most `most` voters whose Sampson errors under F = [e]x H are at most
//! `width` thresholds. The denominators of these errors are computed from the input `e` and are
//! then constant. False if these voters do not determine `e`.
bool PlaneParallax::fit(const Model& F, double width, int most, Vec3d& e) const
{
    const Correspondences& p = voters.view();
    float m[9], errors[MAX_POINTS];
    toFloat(F, m);
    kernelsOf<SampsonError>().errors(p, m, 0, p.size, errors);
    const float widest = (float)(width * width * limit);
    int near[MAX_POINTS], count = 0;
    for (int i = 0; i < p.size && count < most; i += WORD_BITS)
        for (uint64 word = within(errors + i, std::min(p.size - i, (int)WORD_BITS), widest);
             word && count < most; word &= word - 1)
            near[count++] = i + lowestOne(word);
    double weights[6], sums[6] = {0};
    formWeights(e, e, weights);
    for (int j = 0; j < count; ++j)
    {
        const Terms& t = terms[near[j]];
        double denominator = 0;
        for (int k = 0; k < 6; ++k)
            denominator += weights[k] * t.denominator[k];
        const double inverse = denominator > 0 ? 1 / denominator : 0;
        for (int k = 0; k < 6; ++k)
            sums[k] += t.numerator[k] * inverse;
    }
    return smallestEigenvector(
        Matx33d(sums[0], sums[1], sums[2], sums[1], sums[3], sums[4], sums[2], sums[4], sums[5]),
        e);
}

}  // namespace usacv20
}  // namespace cv
