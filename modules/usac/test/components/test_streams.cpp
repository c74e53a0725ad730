// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/streams.hpp"

namespace opencv_test {
namespace {

//! The numbers of the streams of random numbers of all purposes must differ from each other and
//! from those of the samples, which are 0 to INT_MAX, for every number of iterations.
TEST(Usac_Streams, doNotMeet)
{
    uint64 end = INT_MAX;
    for (int stream = STREAM_ROTATION; stream <= STREAM_LEVERAGE; ++stream)
    {
        EXPECT_GT(streamOf((Stream)stream), end) << stream;
        end = streamOf((Stream)stream, (uint64)2 * INT_MAX);
    }
}

}
}  // namespace
