// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_METHOD_NAME_HPP
#define OPENCV_USACV20_BENCHMARK_METHOD_NAME_HPP

#include <string>

namespace benchmark {

/** The parts of a method's name, which has one of the forms `base`, `base+scores`, `base{fields}`,
`base+scores{fields}` or `base{fields}+scores`.
 */
struct MethodName
{
    //! Raises std::runtime_error if a brace is not closed at the end.
    explicit MethodName(const std::string& name);

    std::string full;    //!< as given
    std::string base;    //!< USACV20, preset:ransac, cv:RANSAC, custom:mine
    std::string fields;  //!< text between the braces, "field=value,..."; may be empty
    bool scores;         //!< true: the method uses the scores of the correspondences
};

}  // namespace benchmark

#endif
