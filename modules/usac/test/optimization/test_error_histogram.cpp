// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "optimization/error_mixture.hpp"

namespace opencv_test {
namespace {

//! The bins must have the first errors within the window, at most as many as asked for, and no
//! error that is NaN, infinite or beyond the window.
TEST(Usac_ErrorHistogram, hasTheFirstErrorsWithinTheWindow)
{
    const double unit = 1.5;
    const int window = 3, bins = ErrorHistogram::BINS;
    for (int count : {0, 1, 63, 64, 1000})
        for (int most : {1, 50, 129, 100000})
        {
            SCOPED_TRACE(cv::format("%d errors, at most %d", count, most));
            RNG rng(count);
            std::vector<float> errors(count);
            std::vector<int> members(bins, 0);
            std::vector<double> sums(bins, 0);
            int size = 0;
            for (int i = 0; i < count; ++i)
            {
                const double error = rng.uniform(0., 2. * window * unit);
                errors[i] = i % 7 == 3   ? std::numeric_limits<float>::quiet_NaN()
                            : i % 7 == 5 ? std::numeric_limits<float>::infinity()
                                         : (float)(error * error);
                const double square = errors[i] / (unit * unit);
                if (!(square <= window * window) || size == most)
                    continue;
                const int bin = std::min((int)(std::sqrt(square) * bins / window), bins - 1);
                ++members[bin];
                sums[bin] += square;
                ++size;
            }
            const ErrorHistogram histogram(errors.data(), count, unit, window, most);
            EXPECT_EQ(size, histogram.size);
            for (int b = 0; b < bins; ++b)
            {
                EXPECT_EQ(members[b], histogram.members[b]) << b;
                EXPECT_NEAR(sums[b] / std::max(members[b], 1), histogram.squares[b], 1e-9) << b;
            }
        }
}

}  // namespace
}  // namespace opencv_test
