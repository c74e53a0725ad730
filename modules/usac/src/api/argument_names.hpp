// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ARGUMENT_NAMES_HPP
#define OPENCV_USACV20_ARGUMENT_NAMES_HPP

// Some functions, for example those with the signatures of calib3d, call an estimation function
// whose arguments have other names, such as Usac::create(), which uses the same names for all
// problems. This file translates the argument names in error messages of the called function.

#include <opencv2/core.hpp>

namespace cv {
namespace usacv20 {

//! Name of an argument in the estimation function (`inner`), and in the function that the caller
//! has called (`callers`).
struct ArgumentName
{
    const char *inner, *callers;
};

//! Returns a message with the argument names before the colon, as in "points1 and points2: lists of
//! ...", replaced with those of the caller. Returns the message unchanged if the text before the
//! colon is not a list of names.
String inWordsOf(const ArgumentName* names, size_t count, const String& text);

//! Throws `mistake` with its message translated by inWordsOf(). Returns without throwing if that
//! does not change the message.
void throwInWordsOf(const ArgumentName* names, size_t count, const Exception& mistake);

//! Calls an estimation function and translates the argument names in its exceptions. A handler
//! installed with cv::redirectError receives the original messages.
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
