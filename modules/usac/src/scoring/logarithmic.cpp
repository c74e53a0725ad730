// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Score for a search without a known threshold (#THRESHOLD_ESTIMATED). The cost of a point with
error e <= t is log(1 + e^2 / s^2) / log(1 + t^2 / s^2), where t is Correspondences::threshold, here
an upper bound of the unknown threshold, and s is t / #FINEST; the cost of a point with a larger
error is 1. No noise level between s and t is preferred: doubling an error in this range always
increases the cost by about the same amount. The logarithm is read from the bits of the
floating-point number, that is, it is interpolated linearly between powers of two; this changes the
cost by at most 0.0055. */
class LogarithmicScore : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        const float least = squaredThreshold / (FINEST * FINEST);
        const int zero = bitsOf(least), range = bitsOf(squaredThreshold + least) - zero;
        int64 cost = 0;
        for (int i = 0; i < count; ++i)
        {
            const bool inside = squaredErrors[i] <= squaredThreshold;  // NaN is outside
            sum.inliers += inside;
            cost += inside ? bitsOf(std::max(squaredErrors[i], 0.f) + least) - zero : range;
        }
        sum.cost += (double)cost / range;
    }

private:
    enum { FINEST = 256 };

    static int bitsOf(float value)
    {
        int bits;
        std::memcpy(&bits, &value, sizeof(bits));
        return bits;
    }
};

}  // namespace

Ptr<Score> createLogarithmicScore() { return makePtr<LogarithmicScore>(); }

}  // namespace usacv20
}  // namespace cv
