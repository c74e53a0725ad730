// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PARAMS_FIELDS_HPP
#define OPENCV_USACV20_BENCHMARK_PARAMS_FIELDS_HPP

#include <string>
#include <vector>
#include "opencv2/usac/params.hpp"

namespace benchmark {

//! One "field=value".
struct Field
{
    //! An option of Params may have a name for its value, "sampler=prosac",
    //! "termination=sprt|standard". Anything else, or a value that is no number, raises
    //! std::runtime_error.
    explicit Field(const std::string& assignment);

    //! The value, which must be an integer, or std::runtime_error is raised.
    int integer() const;
    //! Raises std::runtime_error with the assignment and what is wrong with it.
    void fail(const std::string& what) const;

    std::string assignment, name;
    double value;
};

//! The parts of "sampler=1,localIterations=3".
std::vector<Field> parseFields(const std::string& assignments);

/** Sets numeric fields by name: "sampler=prosac,localIterations=3".
An unknown name or a value that is no number raises std::runtime_error. */
void setFields(cv::usacv20::Params& params, const std::string& assignments);

}  // namespace benchmark

#endif
