// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ARGUMENT_NAMES_HPP
#define OPENCV_USACV20_ARGUMENT_NAMES_HPP

// Messages in the words of a function whose arguments have other names than those of the estimation
// that it calls.

#include <opencv2/core.hpp>

namespace cv {
namespace usacv20 {

//! What an estimation calls an argument, and what the caller wrote.
struct ArgumentName
{
    const char *inner, *callers;
};

//! Throws `mistake` with the caller's words in its head, "points1 and points2" of "points1 and
//! points2: lists of ...", if these are other ones. A head that is no list of names stays as it is.
void throwInWordsOf(const ArgumentName* names, size_t count, const Exception& mistake);

//! Calls an estimation; its messages name the arguments as the caller does. cv::redirectError sees
//! them as they were.
template <size_t COUNT, class Call>
auto calling(const ArgumentName (&names)[COUNT], const Call& call) -> decltype(call())
{
    try
    {
        return call();
    }
    catch (const Exception& mistake)
    {
        throwInWordsOf(names, COUNT, mistake);
        throw;
    }
}

}  // namespace usacv20
}  // namespace cv

#endif
