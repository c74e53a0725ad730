// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "numeric/selection.hpp"

namespace opencv_test {
namespace {

//! Few and many values, all different or mostly equal: ranks and medians must be those of the
//! sorted values.
TEST(Usac_Selection, sortedValues)
{
    for (int count = 1; count <= 64; ++count)
        for (int different : {1, 2, 5, 1000000})
        {
            SCOPED_TRACE(cv::format("%d values, %d", count, different));
            RNG rng(1000 * count + different);
            std::vector<double> values(count), sorted;
            for (double& value : values)
                value = rng.uniform(-different, different);
            sorted = values;
            std::sort(sorted.begin(), sorted.end());
            for (int rank = 0; rank < count; ++rank)
                ASSERT_EQ(sorted[rank], ofRank(rank, values.data(), count)) << rank;
            EXPECT_EQ(sorted[count / 2], median(values.data(), count));
        }
}

}  // namespace
}  // namespace opencv_test
