// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PARAMS_FIELDS_HPP
#define OPENCV_USACV20_BENCHMARK_PARAMS_FIELDS_HPP

#include <string>
#include <vector>
#include "opencv2/usac/params.hpp"

namespace benchmark {

//! An assignment "field=value".
struct Field
{
    //! Raises std::runtime_error unless the text has the form name=value. The value is a number or,
    //! for a field of Params with an enumeration, an enumerator without the prefix:
    //! "sampler=prosac". Fields of flags accept several: "termination=sprt|standard".
    explicit Field(const std::string& assignment);

    //! The value; raises std::runtime_error if it is not an integer.
    int integer() const;
    //! Raises std::runtime_error with the assignment and the text `what`.
    void fail(const std::string& what) const;

    std::string assignment, name;
    double value;
};

//! Splits "sampler=1,localIterations=3" into its assignments.
std::vector<Field> parseFields(const std::string& assignments);

/** Sets numeric fields by name: "sampler=prosac,localIterations=3". Raises std::runtime_error for
an unknown name, for a value that is neither a number nor an enumerator of the field, and for a
number that is not an integer if the field needs one. Ranges of values are not checked. */
void setFields(cv::usacv20::Params& params, const std::string& assignments);

}  // namespace benchmark

#endif
