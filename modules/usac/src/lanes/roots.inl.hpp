// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* Real roots of polynomials of degree 10, one polynomial in each lane of the vector registers.
Sturm's theorem isolates the roots in about [-1, 1]. The other roots are inverses of roots of the
reversed polynomial, which has the same coefficients in reverse order. Halley's method inside a
bracket refines the roots to double precision @cite press2007numerical. rootsNearZero() solves the
rare polynomials for which Sturm's sequence is not suitable. No include guard:
lanes/lane_kernels.inl.hpp includes this file once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

constexpr int DEGREE = 10;

//! One polynomial in each lane.
struct Polynomials
{
    //! The values of the polynomials at x, by Horner's scheme.
    Pack value(const Pack& x) const
    {
        Pack result = c[DEGREE];
        for (int i = DEGREE - 1; i >= 0; --i)
            result = result * x + c[i];
        return result;
    }

    Pack c[DEGREE + 1];  //!< coefficients, the constant term first
};

/** Sturm's sequence f[0] = p, f[1] = p', f[2] = -(p mod p'), ..., up to positive factors.
Successive elements are linked by f[k-1] = (a x + b) f[k] - s f[k+1] with s > 0. These links are
used to evaluate the sequence at x, from the last element to the first, with three multiplications
per element. */
struct Sturm
{
    /** Computes the links of the sequences. A sequence ends early if an element divides the
    elements before it up to rounding errors.
    @return the lanes in which all links exist. A link does not exist if the leading coefficient of
    the next element is (nearly) 0, so that the degree decreases by more than 1, as for x^10 - 1. */
    Mask build(const Polynomials& p)
    {
        Pack f[DEGREE + 1], g[DEGREE + 1];
        for (int i = 0; i <= DEGREE; ++i)
            f[i] = p.c[i];
        for (int i = 0; i < DEGREE; ++i)
        {
            g[i] = (i + 1.) * f[i + 1];
            last[i] = Pack();
        }
        Mask regular = f[0] == f[0], open = Pack() == Pack(), closed = Pack() != Pack();
        for (int degree = DEGREE, k = 0; degree > 1; --degree, ++k)
        {
            Pack rest[DEGREE], largest = Pack();
            link(k, f, g, degree, open);
            for (int i = 0; i < degree - 1; ++i)
            {
                rest[i] = b[k] * g[i] + (i > 0 ? a[k] * g[i - 1] : Pack()) - f[i];
                largest = largerOf(largest, absolute(rest[i]));
            }
            const Mask ends = largest <= 1e-14;
            for (int i = 0; i < degree; ++i)
                last[i] = (ends & open) ? g[i] : last[i];
            closed |= ends;
            open &= largest > 1e-14;
            s[k] = open ? largest : Pack();
            regular &= (absolute(rest[degree - 2]) > 1e-5 * largest) | closed;
            const Pack inverse = 1. / largest;
            for (int i = 0; i < degree; ++i)
                f[i] = g[i];
            for (int i = 0; i < degree - 1; ++i)
                g[i] = rest[i] * inverse;
        }
        link(DEGREE - 1, f, g, 1, open);
        s[DEGREE - 1] = Pack();
        last[0] = open ? g[0] : last[0];
        early = bitsOf(closed) != 0;
        return regular;
    }

    //! Number of sign changes in the sequence at x.
    Pack changes(const Pack& x) const
    {
        SignChanges result;
        Pack below = Pack(), here = last[0];
        if (early)
        {
            here = last[DEGREE - 1];
            for (int i = DEGREE - 2; i >= 0; --i)
                here = here * x + last[i];
        }
        for (int k = DEGREE - 1; k >= 0; --k)
        {
            const Pack above = (a[k] * x + b[k]) * here - s[k] * below;
            result.add(above, here);
            below = here;
            here = above;
        }
        return result.count();
    }

private:
    //! Computes the k-th link, between f, of degree `degree`, and the next element g. In lanes
    //! whose sequence has ended (`open` is false), the link becomes f = g.
    void link(int k, const Pack* f, const Pack* g, int degree, const Mask& open)
    {
        const Pack lead = 1. / g[degree - 1], factor = f[degree] * lead,
                   rest = f[degree - 1] - (degree > 1 ? factor * g[degree - 2] : Pack());
        a[k] = open ? factor : Pack();
        b[k] = open ? rest * lead : everywhere(1);
    }

    Pack a[DEGREE], b[DEGREE], s[DEGREE];
    Pack last[DEGREE];  //!< coefficients of the last element of the sequence
    bool early;         //!< true if, in some lane, the last element is not a constant
};

//! Number of intervals of equal length between #LOWEST and #HIGHEST (about -1 and 1, see
//! numeric/polynomial.hpp). Most of them contain at most one root.
constexpr int CELLS = 8;
//! Maximum number of halvings of an interval that contains several roots.
constexpr int HALVINGS = 37;

//! Lower end of the interval with this index; for #CELLS, the upper end of the last interval.
inline double boundOf(int cell)
{
    return cell == CELLS ? HIGHEST : LOWEST + cell * ((HIGHEST - LOWEST) / CELLS);
}

//! Brackets: intervals (low, high] with one root each, in which the polynomial changes its sign. If
//! low = high, this number approximates a multiple root or several nearly equal roots.
struct Brackets
{
    enum { PER_LANE = 2 * DEGREE, MOST = PER_LANE * WIDTH };

    Brackets() : count(0)
    {
        for (int k = 0; k < WIDTH; ++k)
            ofLane[k] = 0;
    }

    void add(int part, int k, double from, double to, double atFrom, double atTo)
    {
        if (ofLane[k] == PER_LANE)  // possible only if rounding errors make the sequence invalid
            return;
        ++ofLane[k];
        reversed[count] = part;
        lanes[count] = k;
        low[count] = from;
        high[count] = to;
        atLow[count] = atFrom;
        atHigh[count++] = atTo;
    }

    int count, ofLane[WIDTH];
    //! The polynomial of a bracket: `reversed` is 1 for a reversed polynomial, else 0; `lanes` is
    //! its lane.
    int reversed[MOST], lanes[MOST];
    //! The ends of a bracket, and the values of the polynomial there.
    double low[MOST], high[MOST], atLow[MOST], atHigh[MOST];
    double roots[MOST];  //!< output of Isolation::refine()
};

//! The polynomials (index 0) and the reversed polynomials (index 1) with their Sturm sequences, and
//! brackets of their roots. `part` is one of these indices.
struct Isolation
{
    Polynomials p[2];
    Sturm sturm[2];
    Brackets brackets;

    //! Adds brackets of the roots of lane k in (low, high]. `fromLow` and `fromHigh` are the
    //! numbers of sign changes in Sturm's sequence at the two ends; their difference is the number
    //! of roots. Halves the interval at most `depth` times.
    void split(int part, int k, double low, double high, double fromLow, double fromHigh, int depth)
    {
        if (!(fromLow > fromHigh))
            return;
        const double atLow = lane(p[part].value(everywhere(low)), k),
                     atHigh = lane(p[part].value(everywhere(high)), k);
        const double middle = 0.5 * (low + high);
        if (fromLow - fromHigh == 1 && (atLow < 0) != (atHigh < 0))
            brackets.add(part, k, low, high, atLow, atHigh);
        else if (depth == 0)  // a multiple root, or several roots that are nearly equal
            brackets.add(part, k, middle, middle, atLow, atHigh);
        else
        {
            const double fromMiddle = lane(sturm[part].changes(everywhere(middle)), k);
            split(part, k, low, middle, fromLow, fromMiddle, depth - 1);
            split(part, k, middle, high, fromMiddle, fromHigh, depth - 1);
        }
    }

    //! Adds brackets of the roots in (LOWEST, HIGHEST] for all lanes whose bit is set in `wanted`.
    void isolate(int part, int wanted)
    {
        Pack from[CELLS + 1], at[CELLS + 1];
        for (int i = 0; i <= CELLS; ++i)
        {
            const Pack x = everywhere(boundOf(i));
            from[i] = sturm[part].changes(x);
            at[i] = p[part].value(x);
        }
        for (int i = 0; i < CELLS; ++i)
        {
            const Pack roots = from[i] - from[i + 1];
            const int some = bitsOf(roots > 0.) & wanted;
            if (some == 0)
                continue;
            const int simple = bitsOf(roots == 1.) & (bitsOf(at[i] < 0.) ^ bitsOf(at[i + 1] < 0.));
            for (int k = 0; k < WIDTH; ++k)
                if ((some & simple) >> k & 1)
                    brackets.add(part, k, boundOf(i), boundOf(i + 1), lane(at[i], k),
                                 lane(at[i + 1], k));
                else if (some >> k & 1)
                    split(part, k, boundOf(i), boundOf(i + 1), lane(from[i], k),
                          lane(from[i + 1], k), HALVINGS);
        }
    }

    //! Computes the roots in all brackets.
    void refine();
};

//! Refines one root in each lane by Halley's method, with bisection where a step leaves the
//! bracket.
struct Refinement
{
    //! @param all polynomials and brackets
    //! @param i lane k refines the root in the bracket i[k]
    void begin(const Isolation& all, const int (&i)[WIDTH])
    {
        const Brackets& brackets = all.brackets;
        double numbers[DEGREE + 5][WIDTH];
        for (int k = 0; k < WIDTH; ++k)
        {
            const Polynomials& from = all.p[brackets.reversed[i[k]]];
            for (int j = 0; j <= DEGREE; ++j)
                numbers[j][k] = lane(from.c[j], brackets.lanes[i[k]]);
            numbers[DEGREE + 1][k] = brackets.low[i[k]];
            numbers[DEGREE + 2][k] = brackets.high[i[k]];
            numbers[DEGREE + 3][k] = brackets.atLow[i[k]];
            numbers[DEGREE + 4][k] = brackets.atHigh[i[k]];
        }
        for (int j = 0; j <= DEGREE; ++j)
            c[j] = load(numbers[j]);
        low = load(numbers[DEGREE + 1]);
        high = load(numbers[DEGREE + 2]);
        atLow = load(numbers[DEGREE + 3]);
        // start where the chord between the ends crosses zero, or in the middle if rounding errors
        // move this point out of the bracket
        const Pack chord = low - atLow / (load(numbers[DEGREE + 4]) - atLow) * (high - low);
        x = ((chord > low) & (chord < high)) ? chord : 0.5 * (low + high);
        active = low == low;
    }

    //! One step from x, where the polynomial has this value and slope; `bend` is half its second
    //! derivative.
    void step(const Pack& value, const Pack& slope, const Pack& bend)
    {
        const Mask left = (value < 0.) == (atLow < 0.);
        low = left ? x : low;
        high = left ? high : x;
        Pack next = x - value * slope / (slope * slope - value * bend);
        const Mask inside = (next > low) & (next < high);
        next = inside ? next : 0.5 * (low + high);
        active &= value != 0.;
        // Halley's method converges cubically: a step of 1e-7 times x leaves a relative error far
        // below 1e-16. Bisection goes on until the bracket is as short as rounding errors.
        const Pack limit = (inside ? everywhere(1e-7) : everywhere(4e-16)) * absolute(x);
        const Mask moving = absolute(next - x) > limit;
        x = active ? next : x;
        active &= moving;
    }

    Pack c[DEGREE + 1], low, high, atLow, x;
    Mask active;  //!< lanes that have not converged
};

void Isolation::refine()
{
    enum { PACKS = 2 };  // packs that are processed together, to hide the latency of operations
    for (int first = 0; first < brackets.count; first += PACKS * WIDTH)
    {
        Refinement r[PACKS];
        for (int u = 0; u < PACKS; ++u)
        {
            int wanted[WIDTH];
            for (int k = 0; k < WIDTH; ++k)
            {
                const int i = first + u * WIDTH + k;
                wanted[k] = i < brackets.count ? i : brackets.count - 1;
            }
            r[u].begin(*this, wanted);
        }
        for (int i = 0; i < 60 && (bitsOf(r[0].active) | bitsOf(r[1].active)) != 0; ++i)
        {
            Pack value[PACKS], slope[PACKS], bend[PACKS];
            for (int u = 0; u < PACKS; ++u)
            {
                value[u] = r[u].c[DEGREE];
                slope[u] = bend[u] = Pack();
            }
            for (int j = DEGREE - 1; j >= 0; --j)
                for (int u = 0; u < PACKS; ++u)
                {
                    bend[u] = bend[u] * r[u].x + slope[u];
                    slope[u] = slope[u] * r[u].x + value[u];
                    value[u] = value[u] * r[u].x + r[u].c[j];
                }
            for (int u = 0; u < PACKS; ++u)
                r[u].step(value[u], slope[u], bend[u]);
        }
        for (int i = first; i < first + PACKS * WIDTH && i < brackets.count; ++i)
            brackets.roots[i] = lane(r[(i - first) / WIDTH].x, (i - first) % WIDTH);
    }
}

//! Real roots of the polynomials. Lane k has count[k] roots, which are in lane k of the first
//! elements of `at`.
struct Roots
{
    int count[WIDTH];
    Pack at[MAX_MODELS];

    //! Computes the roots.
    //! @param coefficients coefficients of the polynomials, the constant first
    //! @param wanted lanes to solve, a bit for each; the other lanes get no roots
    void find(const Pack (&coefficients)[DEGREE + 1], int wanted)
    {
        for (int k = 0; k < WIDTH; ++k)
            count[k] = 0;
        for (int i = 0; i < MAX_MODELS; ++i)
            at[i] = Pack();
        Isolation all;
        Pack largest = Pack();
        for (int i = 0; i <= DEGREE; ++i)
            largest = largerOf(largest, absolute(coefficients[i]));
        const Pack inverse = 1. / largest;
        for (int i = 0; i <= DEGREE; ++i)
            all.p[0].c[i] = all.p[1].c[DEGREE - i] = coefficients[i] * inverse;
        for (int part = 0; part < 2; ++part)
        {
            // where `full` is false, the degree is lower than Sturm::build() assumes
            const Mask full = absolute(all.p[part].c[DEGREE]) > 1e-14;
            const int regular = wanted & bitsOf(full & all.sturm[part].build(all.p[part]));
            all.isolate(part, regular);
            for (int k = 0; k < WIDTH; ++k)
                if ((wanted & ~regular) >> k & 1)
                    addSlowly(part, k, all.p[part]);
        }
        all.refine();
        for (int i = 0; i < all.brackets.count; ++i)
            add(all.brackets.reversed[i], all.brackets.lanes[i], all.brackets.roots[i]);
    }

private:
    //! Adds a root to lane k.
    //! @param part 0: `near` is the root; 1: 1 / `near` is the root
    //! @param near root of the polynomial or of the reversed polynomial. A root 1 / `near` in
    //! (LOWEST, HIGHEST] is not added, because it is also found in part 0.
    void add(int part, int k, double near)
    {
        const double root = part == 0 ? near : 1 / near;
        if (count[k] < DEGREE && (part == 0 || root <= LOWEST || root > HIGHEST))
            setLane(at[count[k]++], k, root);
    }

    //! Finds the roots near zero of one part in one lane with rootsNearZero(), which is slower, but
    //! works for every polynomial.
    void addSlowly(int part, int k, const Polynomials& p)
    {
        double c[DEGREE + 1], roots[MAX_DEGREE];
        for (int i = 0; i <= DEGREE; ++i)
            c[i] = lane(p.c[i], k);
        const int found = rootsNearZero(c, DEGREE, roots);
        for (int i = 0; i < found; ++i)
            add(part, k, roots[i]);
    }
};

}  // namespace
}  // namespace usacv20
}  // namespace cv
