// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_TASKS_HPP
#define OPENCV_USACV20_BATCH_TASKS_HPP

#include <functional>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

/** @brief Many estimations side by side: the threads of cv::parallel_for_ take the next one when
they have done one.
@param count how many
@param threads of them at once, at most cv::getNumThreads(); 0: as many as that. Raises
cv::Exception if it is below 0
@param estimate does one of them, by its number; raises nothing
@param leave is called for those that are not begun, as a ProgressScope has said no */
void forEachTask(int count, int threads, const std::function<void(int)>& estimate,
                 const std::function<void(int)>& leave);

//! Calls an estimation. @return the message of what it has raised; empty: nothing
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
