// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "control/watch.hpp"

namespace opencv_test {
namespace {

//! A progress function can be called before the search has begun, that is, before Watch::begin()
//! has set the State from which reports are made. It must then get a report with the elapsed time
//! (Report::searchMs), the cost 1 of a run without a model, and no iterations or inliers.
TEST(Usac_Watch, progress_before_the_search)
{
    std::vector<Report> seen;
    const ProgressScope scope([&seen](const Report& now) {
        seen.push_back(now);
        return false;
    });
    Watch watch(0, (int64)getTickFrequency());  // the run has already taken a second
    EXPECT_TRUE(watch.stop(1e9));
    EXPECT_EQ((int)STOP_CANCELLED, watch.stopReason());
    ASSERT_EQ(1u, seen.size());
    EXPECT_EQ((int)STOP_NOT_RUN, seen[0].stop);
    EXPECT_GE(seen[0].searchMs, 999);
    EXPECT_EQ(1, seen[0].cost);
    EXPECT_EQ(0, seen[0].iterations);
    EXPECT_EQ(0, seen[0].inliers);
}

}  // namespace
}  // namespace opencv_test
