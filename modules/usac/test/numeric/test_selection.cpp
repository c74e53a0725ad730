// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "numeric/selection.hpp"

namespace opencv_test {
namespace {

//! Random values, one of them infinite: ranks and medians must be those of the sorted values.
template <class T>
void expectSorted(int count, int different)
{
    SCOPED_TRACE(cv::format("%d values, %d", count, different));
    RNG rng(1000 * count + different);
    std::vector<T> values(count), sorted;
    for (T& value : values)
        value = (T)rng.uniform(-different, different);
    values[count / 2] = std::numeric_limits<T>::infinity();
    sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (int rank = 0; rank < count; ++rank)
        ASSERT_EQ(sorted[rank], ofRank(rank, values.data(), count)) << rank;
    EXPECT_EQ(sorted[count / 2], median(values.data(), count));
}

//! Few and many values, all different or mostly equal.
TEST(Usac_Selection, sortedValues)
{
    for (int count = 1; count <= 64; ++count)
        for (int different : {1, 2, 5, 1000000})
        {
            expectSorted<double>(count, different);
            expectSorted<float>(count, different);
        }
}

}  // namespace
}  // namespace opencv_test
