// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/match_noise.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Step of the differences with which points are converted, in units of the normalized image plane.
//! Lens distortion is linear within this distance up to about the square of the step.
constexpr double STEP = 1e-4;

//! Replaces the 2x2 matrix [a b; c d] by the root [p 0; q s] of the same covariance.
void toRoot(double a, double b, double c, double d, double& p, double& q, double& s)
{
    p = std::sqrt(a * a + b * b);
    q = p > 0 ? (a * c + b * d) / p : 0;
    s = p > 0 ? std::abs(a * d - b * c) / p : std::sqrt(c * c + d * d);
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

//! Variance of isotropic noise that leads to about the same variance of the error: for an error in
//! the plane, with noise in both images, the determinants of the covariances of the errors are
//! equal for a map that does not change lengths; for a distance from a line, the average over
//! all directions of the lines.
double MatchNoise::variance(int match) const
{
    const float* const c = &sigmas[(size_t)match * each];
    if (each == 1)
        return (double)c[0] * c[0];
    double xx = c[0], xy = c[1], yy = c[2];
    if (each == 6)
    {
        xx += c[3];
        xy += c[4];
        yy += c[5];
    }
    return problem.errorDimension() == 1 ? (xx + yy) / 4 : std::sqrt(xx * yy - xy * xy);
}

double MatchNoise::mean() const
{
    const int degrees = problem.errorDimension();
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += each == 1 ? std::pow((double)sigmas[i], degrees)
                         : std::pow(variance(i), 0.5 * degrees);
    return std::pow(sum / count, 1. / degrees);
}

void MatchNoise::toColumns(const double* const* taken, bool image, double* const* noise,
                           Arena& arena) const
{
    if (each == 1)
    {
        const double unit = mean();
        for (int i = 0; i < count; ++i)
            noise[0][i] = unit / sigmas[i];
        return;
    }
    const int last = problem.coordinates(0);
    readRoots(0, noise);
    transform(taken, image, last, noise, arena);
    if (columnsOf(problem, sigmas, count) < 6)
        return;
    readRoots(3, noise + 3);
    transform(taken, image, 0, noise + 3, arena);
}

//! Computes the roots of the covariances, of which the first number of each match is number
//! `first`, in units of mean(). Points without covariance are exact.
void MatchNoise::readRoots(int first, double* const* root) const
{
    const double unit = mean();
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

/** Converts roots to the coordinates of the model: multiplies them by the derivative of the
conversion of points and by the number of pixels per unit. The derivative is computed by central
differences.
@param array first column of the points to which the roots belong */
void MatchNoise::transform(const double* const* taken, bool image, int array, double* const* root,
                           Arena& arena) const
{
    Arena::Scope scope(arena);
    const int columns = problem.coordinates(0) + problem.coordinates(1);
    double *moved[MAX_COLUMNS], *product[4];
    for (int k = 0; k < columns; ++k)
        moved[k] = scope.take<double>(count);
    for (int k = 0; k < 4; ++k)
    {
        product[k] = scope.take<double>(count);
        std::fill(product[k], product[k] + count, 0.);
    }
    const double pixels = convert(moved, 0, false), step = STEP * pixels;
    for (int direction = 0; direction < 2; ++direction)
        for (int sign = -1; sign <= 1; sign += 2)
        {
            for (int k = 0; k < columns; ++k)
                std::copy(taken[k], taken[k] + count, moved[k]);
            for (int i = 0; i < count; ++i)
                moved[array + direction][i] += sign * step;
            convert(moved, count, image);
            const double factor = sign * pixels / (2 * step);
            for (int i = 0; i < count; ++i)
            {
                // row `direction` of the root [p 0; q s]
                const double first = factor * root[direction][i],
                             second = direction ? factor * root[2][i] : 0;
                product[0][i] += moved[array][i] * first;
                product[1][i] += moved[array][i] * second;
                product[2][i] += moved[array + 1][i] * first;
                product[3][i] += moved[array + 1][i] * second;
            }
        }
    for (int i = 0; i < count; ++i)
        toRoot(product[0][i], product[1][i], product[2][i], product[3][i], root[0][i], root[1][i],
               root[2][i]);
}

//! Converts points to the coordinates of the model. @return number of pixels per unit
double MatchNoise::convert(double* const* columns, int points, bool image) const
{
    if (!image)
        return problem.toModelCoordinates(columns, points);
    problem.toImageCoordinates(columns, points);
    return 0;
}

}  // namespace usacv20
}  // namespace cv
