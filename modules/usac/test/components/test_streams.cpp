// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/streams.hpp"

namespace opencv_test {
namespace {

//! Random numbers come from numbered streams. Each purpose (enum Stream) has a range of streams of
//! its own, one stream for each iteration. These ranges must not overlap each other or the range of
//! the samples, 0 to INT_MAX, however many iterations there are.
TEST(Usac_Streams, doNotMeet)
{
    uint64 end = INT_MAX;
    for (int stream = STREAM_ROTATION; stream <= STREAM_WRONG; ++stream)
    {
        EXPECT_GT(streamOf((Stream)stream), end) << stream;
        end = streamOf((Stream)stream, (uint64)2 * INT_MAX);
    }
}

}  // namespace
}  // namespace opencv_test
