// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* Pack, a vector register: each of its lanes holds a number that belongs to one of several samples,
which are solved together. No operation mixes lanes, so that the result of a sample is bit-identical
for every number of lanes. No include guard: lanes/lane_kernels.inl.hpp includes this file once for
each instruction set. */

#if defined __SSE2__
#include <immintrin.h>
#endif

namespace cv {
namespace usacv20 {
namespace {

//! For roughCubeRoot(): 2 / 3 of the upper 32 bits of the double 1, reduced so that the roots
//! become 2 to 3 % smaller, which makes the largest positive and negative errors about equal.
constexpr unsigned long long TWO_THIRDS_OF_ONE = 715094163;

#if defined __GNUC__

//! Number of lanes of a Pack.
#if defined __AVX512F__
constexpr int WIDTH = 8;
#elif defined __AVX__
constexpr int WIDTH = 4;
#else
constexpr int WIDTH = 2;
#endif
typedef double Pack __attribute__((vector_size(WIDTH * sizeof(double))));
//! Result of a comparison: all bits of a lane are set, or none.
typedef decltype(Pack() < Pack()) Mask;

inline double lane(const Pack& p, int k) { return p[k]; }
inline void setLane(Pack& p, int k, double value) { p[k] = value; }

typedef unsigned long long Bits __attribute__((vector_size(WIDTH * sizeof(double))));

inline Pack absolute(const Pack& p) { return (Pack)((Bits)p & LLONG_MAX); }

//! Cube root of positive numbers with an error of a few percent. The upper 32 bits of a double grow
//! nearly linearly with its logarithm: a third of them, plus two thirds of the upper bits of the
//! number 1, are about the upper bits of the cube root.
inline Pack roughCubeRoot(const Pack& p)
{
    const Bits third = ((Bits)p >> 32) * 0x55555556 >> 32;
    return (Pack)((third + TWO_THIRDS_OF_ONE) << 32);
}

//! Converts a mask to an integer whose bit k is set if lane k of the mask is set.
inline int bitsOf(const Mask& mask)
{
#if defined __AVX512F__
    return _mm512_movepi64_mask((__m512i)mask);
#elif defined __AVX__
    return _mm256_movemask_pd((__m256d)mask);
#elif defined __SSE2__
    return _mm_movemask_pd((__m128d)mask);
#else
    int bits = 0;
    for (int k = 0; k < WIDTH; ++k)
        bits |= (mask[k] != 0) << k;
    return bits;
#endif
}

//! Counts, in each lane, those pairs passed to add() whose numbers have different sign bits; 0
//! counts as positive, -0 as negative.
class SignChanges
{
public:
    SignChanges() : bits((Bits)(Pack() + FIRST)) {}
    void add(const Pack& a, const Pack& b) { bits += ((Bits)a ^ (Bits)b) >> 63; }
    Pack count() const { return (Pack)bits - FIRST; }

private:
    // 2^52: the last bit of a double of this size has the value 1, so that adding an integer to the
    // bits adds the same number to the double
    static constexpr double FIRST = 4503599627370496.;
    Bits bits;
};

#else  // compilers without vector types: a Pack is a single number

constexpr int WIDTH = 1;
typedef double Pack;
typedef bool Mask;

inline double lane(const Pack& p, int) { return p; }
inline void setLane(Pack& p, int, double value) { p = value; }
inline Pack absolute(const Pack& p) { return ::fabs(p); }

inline Pack roughCubeRoot(const Pack& p)
{
    unsigned long long bits;
    memcpy(&bits, &p, sizeof(bits));
    bits = (((bits >> 32) * 0x55555556 >> 32) + TWO_THIRDS_OF_ONE) << 32;
    double result;
    memcpy(&result, &bits, sizeof(bits));
    return result;
}

inline int bitsOf(const Mask& mask) { return mask; }

class SignChanges
{
public:
    SignChanges() : changes(0) {}
    void add(const Pack& a, const Pack& b) { changes += std::signbit(a) != std::signbit(b); }
    Pack count() const { return changes; }

private:
    int changes;
};

#endif

//! A Pack with values[k] in lane k.
inline Pack load(const double (&values)[WIDTH])
{
    Pack result = Pack();
    for (int k = 0; k < WIDTH; ++k)
        setLane(result, k, values[k]);
    return result;
}

inline Pack everywhere(double value) { return Pack() + value; }

//! largerOf() and smallerOf(): maximum and minimum in each lane; where `a` or `b` is NaN, the
//! result is `a`.
inline Pack largerOf(const Pack& a, const Pack& b) { return b > a ? b : a; }
inline Pack smallerOf(const Pack& a, const Pack& b) { return b < a ? b : a; }

inline Pack squareRoot(const Pack& p)
{
    Pack result = p;
    for (int k = 0; k < WIDTH; ++k)
        setLane(result, k, ::sqrt(lane(p, k)));
    return result;
}

inline Pack square(const Pack& p) { return p * p; }

//! a b + c d + e f
inline Pack dot3(const Pack& a, const Pack& b, const Pack& c, const Pack& d, const Pack& e,
                 const Pack& f)
{
    return a * b + c * d + e * f;
}

inline Pack dot9(const Pack (&a)[9], const Pack (&b)[9])
{
    Pack sum = a[0] * b[0];
    for (int i = 1; i < 9; ++i)
        sum += a[i] * b[i];
    return sum;
}

//! Exchanges the elements first .. COUNT-1 of two arrays in the lanes that are set in a mask.
template <int COUNT>
inline void exchange(const Mask& mask, int first, Pack (&a)[COUNT], Pack (&b)[COUNT])
{
    if (bitsOf(mask) == 0)
        return;
    for (int i = first; i < COUNT; ++i)
    {
        const Pack before = a[i];
        a[i] = mask ? b[i] : before;
        b[i] = mask ? before : b[i];
    }
}

//! The cofactors of a 3x3 matrix, row by row.
inline void cofactors(const Pack (&m)[9], Pack (&c)[9])
{
    c[0] = m[4] * m[8] - m[5] * m[7];
    c[1] = m[5] * m[6] - m[3] * m[8];
    c[2] = m[3] * m[7] - m[4] * m[6];
    c[3] = m[2] * m[7] - m[1] * m[8];
    c[4] = m[0] * m[8] - m[2] * m[6];
    c[5] = m[1] * m[6] - m[0] * m[7];
    c[6] = m[1] * m[5] - m[2] * m[4];
    c[7] = m[2] * m[3] - m[0] * m[5];
    c[8] = m[0] * m[4] - m[1] * m[3];
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
