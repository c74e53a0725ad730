// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FUZZ_INPUT_HPP
#define OPENCV_USACV20_TEST_FUZZ_INPUT_HPP

#include "support/result_oracle.hpp"

namespace opencv_test {

struct FuzzInput : EstimatorCall
{
    int otherThreads;  //!< number of threads of the second run if Params::threads is 1
};

/** Makes a call from arbitrary bytes. A small change of the bytes mostly makes a small change of
the call: the bytes give first the problem, the preset and the changed fields, then the cameras, the
points, changes of the points, and the scores. Valid numbers of iterations, samples and threads are
reduced, because large ones only cost time. Everything else is arbitrary. */
FuzzInput readFuzzInput(const uchar* data, size_t size);

}  // namespace opencv_test

#endif
