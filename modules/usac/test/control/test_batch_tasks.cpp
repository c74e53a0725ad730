// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <stdexcept>
#include "test_precomp.hpp"
#include "control/batch_tasks.hpp"

namespace opencv_test {
namespace {

//! If an estimation of a batch raises a cv::Exception or another std::exception (for example
//! std::bad_alloc), mistakeOf() must return the message of the exception. Exceptions of other
//! types, which have no message, are not caught.
TEST(Usac_BatchTasks, mistakes)
{
    EXPECT_EQ("", mistakeOf([] {}));
    EXPECT_EQ("threshold: wrong",
              mistakeOf([] { CV_Error(Error::StsBadArg, "threshold: wrong"); }));
    EXPECT_EQ("no such thing", mistakeOf([] { throw std::runtime_error("no such thing"); }));
    EXPECT_EQ(std::bad_alloc().what(), std::string(mistakeOf([] { throw std::bad_alloc(); })));
    EXPECT_THROW(mistakeOf([] { throw 1; }), int) << "an exception without a message";
}

}  // namespace
}  // namespace opencv_test
