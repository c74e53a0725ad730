// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/match_noise.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Step of the central differences that approximate the derivative of the conversion of points, see
//! stepAt(): at least STEP in the coordinates of the model (E: on the normalized image plane), and
//! at least RELATIVE_STEP times the given coordinate, so that rounding errors of points far away
//! are small. For a lens distortion, the error of this approximation is about the square of STEP.
//! See doc/constants.md.
constexpr double STEP = 1e-4, RELATIVE_STEP = 1e-6;

//! Computes the triangular root L = [p 0; q s] of the covariance M M^T with M = [a b; c d], so that
//! L L^T = M M^T.
void toRoot(double a, double b, double c, double d, double& p, double& q, double& s)
{
    p = std::sqrt(a * a + b * b);
    q = p > 0 ? (a * c + b * d) / p : 0;
    s = p > 0 ? std::abs(a * d - b * c) / p : std::sqrt(c * c + d * d);
}

//! The step for a coordinate that the caller has given, in its unit (pixels).
//! @param pixels number of pixels per unit of the coordinates of the model
double stepAt(double coordinate, double pixels)
{
    return std::max(STEP * pixels, RELATIVE_STEP * std::abs(coordinate));
}

}  // namespace

int MatchNoise::columnsOf(const Problem& problem, const std::vector<float>& sigmas, int count)
{
    if (sigmas.empty() || (int)sigmas.size() == count)
        return sigmas.empty() ? 0 : 1;
    const int each = (int)sigmas.size() / count, first = problem.coordinates(0);
    const bool images = first == 2 && problem.commonUnit();
    if (problem.coordinates(1) != 2 || (!images && each > 3))
        CV_Error_(Error::StsBadArg,
                  ("sigmas: the problem %s takes %s for each of the %d correspondences, not %d",
                   problem.name().c_str(),
                   problem.coordinates(1) == 2 ? "one or three numbers" : "one number", count,
                   each));
    return images ? 6 : 3;
}

MatchNoise::MatchNoise(const Problem& problem_, const std::vector<float>& sigmas_, int count_)
    : problem(problem_), sigmas(sigmas_), count(count_), each((int)sigmas.size() / count), unit(0)
{
    const int degrees = problem.errorDimension();
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += each == 1 ? std::pow((double)sigmas[i], degrees)
                         : std::pow(variance(i), 0.5 * degrees);
    unit = std::pow(sum / count, 1. / degrees);
}

double MatchNoise::sigma(int match) const
{
    return each == 1 ? sigmas[match] : std::sqrt(variance(match));
}

/** Variance of the isotropic noise that gives the error of a match about the same variance as the
covariances S1 and S2 of its points in images 1 and 2.

If errors are vectors in the plane, the isotropic noise is in image 2 only. The result is the square
root of the mean determinant of S2 + R S1 R^T over all rotations R, because a map can rotate the
noise of image 1. If errors are Sampson distances, the isotropic noise is equal in both images. The
result is the variance of the Sampson distance, averaged over the directions of the epipolar lines;
with noise of variance v in both images, it is v. */
double MatchNoise::variance(int match) const
{
    const float* const c = &sigmas[(size_t)match * each];
    const double trace2 = (double)c[0] + c[2],
                 determinant2 = (double)c[0] * c[2] - (double)c[1] * c[1];
    const bool both = each == 6;
    const double trace1 = both ? (double)c[3] + c[5] : 0,
                 determinant1 = both ? (double)c[3] * c[5] - (double)c[4] * c[4] : 0;
    if (problem.errorDimension() == 1)
        return (trace1 + trace2) / 4;
    return std::sqrt(determinant1 + determinant2 + trace1 * trace2 / 2);
}

void MatchNoise::toColumns(const double* const* taken, bool image, double* const* noise,
                           Arena& arena) const
{
    if (each == 1)
    {
        for (int i = 0; i < count; ++i)
            noise[0][i] = unit / sigmas[i];
        return;
    }
    const bool images = columnsOf(problem, sigmas, count) == 6;
    readRoots(0, noise);
    if (images)
        readRoots(3, noise + 3);
    transform(taken, image, images, noise, arena);
}

//! Computes the roots (p, q, s) of the covariances of the points of one array, divided by mean().
//! @param first index of xx among the numbers of a match; if there are no such numbers, the points
//! of this array are exact, and their roots are 0
void MatchNoise::readRoots(int first, double* const* root) const
{
    for (int i = 0; i < count; ++i)
    {
        root[0][i] = root[1][i] = root[2][i] = 0;
        if (first >= each)
            continue;
        const float* const c = &sigmas[(size_t)i * each + first];
        const double p = std::sqrt((double)c[0]), q = p > 0 ? c[1] / p : 0;
        root[0][i] = p / unit;
        root[1][i] = q / unit;
        root[2][i] = std::sqrt(std::max(c[2] - q * q, 0.)) / unit;
    }
}

/** Converts roots from pixels to the coordinates of the model: multiplies them by the derivative of
the conversion of points and by the number of pixels per unit. The derivative is computed by central
differences.
@param taken, image as in toColumns()
@param both true: there are roots for both arrays, false: only for the last one
@param noise input: the roots in pixels; output: the converted roots. Three columns for the last
array, then, if `both` is true, three for the first array */
void MatchNoise::transform(const double* const* taken, bool image, bool both, double* const* noise,
                           Arena& arena) const
{
    Arena::Scope scope(arena);
    enum { ENTRIES = 4 };
    const int columns = problem.coordinates(0) + problem.coordinates(1), images = both ? 2 : 1;
    const int first[] = {problem.coordinates(0), 0};  // column of x in the last and first array
    double *moved[MAX_COLUMNS], *product[2 * ENTRIES];
    for (int k = 0; k < columns; ++k)
        moved[k] = scope.take<double>(count);
    for (int k = 0; k < images * ENTRIES; ++k)
    {
        product[k] = scope.take<double>(count);
        std::fill(product[k], product[k] + count, 0.);
    }
    const double pixels = convert(moved, 0, false);
    for (int direction = 0; direction < 2; ++direction)
        for (int sign = -1; sign <= 1; sign += 2)
        {
            for (int k = 0; k < columns; ++k)
                std::copy(taken[k], taken[k] + count, moved[k]);
            for (int which = 0; which < images; ++which)
                for (int i = 0; i < count; ++i)
                {
                    double& x = moved[first[which] + direction][i];
                    x += sign * stepAt(x, pixels);
                }
            convert(moved, count, image);
            for (int which = 0; which < images; ++which)
            {
                const double *const x = moved[first[which]], *const y = moved[first[which] + 1];
                const double* const at = taken[first[which] + direction];
                double *const *const root = noise + 3 * which, *const *const to = product +
                                                                                  ENTRIES * which;
                for (int i = 0; i < count; ++i)
                {
                    const double factor = sign * pixels / (2 * stepAt(at[i], pixels));
                    // row `direction` of the root [p 0; q s]
                    const double left = factor * root[direction][i],
                                 right = direction ? factor * root[2][i] : 0;
                    to[0][i] += x[i] * left;
                    to[1][i] += x[i] * right;
                    to[2][i] += y[i] * left;
                    to[3][i] += y[i] * right;
                }
            }
        }
    for (int which = 0; which < images; ++which)
        for (int i = 0; i < count; ++i)
        {
            double *const *const from = product + ENTRIES * which, *const *const to = noise +
                                                                                      3 * which;
            toRoot(from[0][i], from[1][i], from[2][i], from[3][i], to[0][i], to[1][i], to[2][i]);
        }
}

//! Converts points to the coordinates of the model. @return number of pixels per unit. If `image`
//! is true: converts points by Problem::toImageCoordinates instead and returns 0.
double MatchNoise::convert(double* const* columns, int points, bool image) const
{
    if (!image)
        return problem.toModelCoordinates(columns, points);
    problem.toImageCoordinates(columns, points);
    return 0;
}

}  // namespace usacv20
}  // namespace cv
