// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! log(n!) minus Stirling's formula, n > 0.
double stirlingError(double n)
{
    if (n > 15)
    {
        const double r = 1 / (n * n);
        return (1. / 12 - (1. / 360 - (1. / 1260 - r / 1680) * r) * r) / n;
    }
    double factorial = 1;
    for (int i = 2; i <= (int)n; ++i)
        factorial *= i;
    return std::log(factorial) - 0.5 * std::log(2 * CV_PI * n) - n * std::log(n) + n;
}

//! x log(x / mean) + mean - x, x > 0.
double deviance(double x, double mean)
{
    return mean - x + x * (2 * mean < x ? std::log(x / mean) : -std::log1p((mean - x) / x));
}

//! P(Binomial(n, p) = k) for 0 <= k <= n, 0 < p < 1.
double binomial(double k, double n, double p)
{
    if (k == 0)
        return std::exp(n * std::log1p(-p));
    if (k == n)
        return std::exp(n * std::log(p));
    const double exponent = stirlingError(n) - stirlingError(k) - stirlingError(n - k) - deviance(k, n * p) -
                            deviance(n - k, n * (1 - p));
    return std::exp(exponent) * std::sqrt(n / (2 * CV_PI * k * (n - k)));
}

//! P(Binomial(n, p) >= k)
double upperTail(int k, int n, double p)
{
    const double odds = p / (1 - p);
    double sum = 0;
    if (k > n * p)
    {
        double term = binomial(k, n, p);
        for (int j = k; j <= n && term > 1e-17 * sum; ++j)
        {
            sum += term;
            term *= (double)(n - j) / (j + 1) * odds;
        }
        return std::min(sum, 1.);
    }
    double term = binomial(k - 1, n, p);
    for (int j = k - 1; j >= 0 && term > 1e-17 * sum; --j)
    {
        sum += term;
        term *= j / ((double)(n - j + 1) * odds);
    }
    return std::max(1 - sum, 0.);
}

//! Cells of a space that something lies in: a hash table with linear probing.
class Cells
{
public:
    Cells(int capacity, Arena& arena) : scope(arena), mask(1)
    {
        while (mask < 2 * capacity)
            mask *= 2;
        slots = scope.take<Vec3d>(mask);
        std::fill(slots, slots + mask, Vec3d(NAN, NAN, NAN));
        --mask;
    }

    //! False if the cell is there already. Doubles, as small sides make large numbers.
    bool insert(const Vec3d& cell)
    {
        uint64 bits[3];
        std::memcpy(bits, cell.val, sizeof(bits));
        // small whole numbers have zeros but for their highest bits, which a product moves nowhere but up
        uint64 h = bits[0] ^ (bits[1] << 1 | bits[1] >> 63) ^ (bits[2] << 2 | bits[2] >> 62);
        h = (h ^ h >> 32) * 0x9e3779b97f4a7c15ULL;
        int at = (int)(h >> 40) & mask;
        for (; slots[at][0] == slots[at][0]; at = (at + 1) & mask)
            if (slots[at] == cell)
                return false;
        slots[at] = cell;
        return true;
    }

private:
    Arena::Scope scope;
    Vec3d* slots;  //!< NaN: free
    int mask;
};

}  // namespace

double chanceOf(int inliers, int n, int m, double randomRatio)
{
    if (inliers <= m)
        return 1;
    if (inliers > n || !(randomRatio > 0))
        return 0;
    return randomRatio < 1 ? upperTail(inliers - m, n - m, randomRatio) : 1;
}

int independentInliers(const double* const* columns, const int* coordinates, const uchar* mask, int count,
                       double threshold1, double threshold2, Arena& arena)
{
    Arena::Scope scope(arena);
    uchar *const repeated1 = scope.take<uchar>(count), *const repeated2 = scope.take<uchar>(count);
    std::fill(repeated1, repeated1 + count, (uchar)0);
    std::fill(repeated2, repeated2 + count, (uchar)0);
    const int repetitions = std::max(
        markRepeated(columns, coordinates[0], 0, mask, count, threshold1, repeated1, arena),
        markRepeated(columns + coordinates[0], coordinates[1], 0, mask, count, threshold2, repeated2, arena));
    int inliers = 0;
    for (int i = 0; i < count; ++i)
        inliers += mask[i] != 0;
    return inliers - repetitions;
}

int markRepeated(const double* const* columns, int dimensions, const int* order, const uchar* mask, int count,
                 double side, uchar* repeated, Arena& arena)
{
    int marked = 0;
    for (int i = 0; i < count; ++i)
        marked += mask[i] != 0;
    Cells cells(marked, arena);
    for (int i = 0; i < count && dimensions > 0; ++i)
        if (mask[i])
        {
            const int point = order ? order[i] : i;
            Vec3d cell;
            for (int k = 0; k < dimensions; ++k)
                cell[k] = (side > 0 ? std::floor(columns[k][point] / side) : columns[k][point]) + 0.;  // no -0
            if (!cells.insert(cell))
                repeated[i] = 1;
        }
    int sum = 0;
    for (int i = 0; i < count; ++i)
        sum += repeated[i];
    return sum;
}

int markRepeated(const Correspondences& p, const int* order, const uchar* mask, int count, double threshold,
                 uchar* repeated, Arena& arena)
{
    const double threshold1 = p.problem->commonUnit() ? threshold * p.frame[0].scale / p.frame[1].scale : 0;
    markRepeated(p.exact, p.coordinates[0], order, mask, count, threshold1, repeated, arena);
    return markRepeated(p.exact + p.coordinates[0], p.coordinates[1], order, mask, count, threshold, repeated, arena);
}

}  // namespace usacv20
}  // namespace cv
