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
    //! Raises std::runtime_error if the name has a '{', but no '}' at its end or before `+scores`.
    explicit MethodName(const std::string& name);

    std::string full;    //!< the whole name
    std::string base;    //!< for example USACV20, preset:ransac, cv:RANSAC or custom:mine
    std::string fields;  //!< text between the braces, "field=value,..."; empty without braces
    bool scores;         //!< true if the name has `+scores`
};

}  // namespace benchmark

#endif
