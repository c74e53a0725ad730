// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_TASKS_HPP
#define OPENCV_USACV20_BATCH_TASKS_HPP

#include <functional>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief Runs many estimations in parallel: each thread of cv::parallel_for_ takes the next
estimation when it has finished one.
@param count number of estimations
@param threads how many run at once, at most cv::getNumThreads(); 0: cv::getNumThreads(). Raises
cv::Exception if negative
@param estimate runs the estimation with a given index; must not throw
@param leave called instead of `estimate` after a ProgressScope has cancelled the batch */
void forEachTask(int count, int threads, const std::function<void(int)>& estimate,
                 const std::function<void(int)>& leave);

//! Calls an estimation. @return the message of the exception that it raised, or an empty string
template <class Call>
String mistakeOf(const Call& call)
{
    try
    {
        call();
    }
    catch (const Exception& mistake)
    {
        return mistake.err;
    }
    catch (const std::exception& mistake)
    {
        return mistake.what();
    }
    return String();
}

}  // namespace usacv20
}  // namespace cv

#endif
