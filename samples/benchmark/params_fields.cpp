// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "params_fields.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include "opencv2/usac/params_fields.hpp"

namespace benchmark {

using cv::usacv20::FieldValues;
using cv::usacv20::Params;

namespace {

//! Gives the field of that name, if it is a numeric one, its value.
struct Assignment
{
    Params& params;
    const Field& assigned;
    bool done;

    void operator()(const char* name, double Params::*member, const FieldValues&)
    {
        if (isIt(name))
            params.*member = assigned.value;
    }
    void operator()(const char* name, int Params::*member, const FieldValues&)
    {
        if (isIt(name))
            params.*member = assigned.integer();
    }
    template <class T>
    void operator()(const char*, std::vector<T> Params::*, const FieldValues&)
    {}

    bool isIt(const char* name)
    {
        const bool is = assigned.name == name;
        done = done || is;
        return is;
    }
};

void setField(Params& params, const Field& assigned)
{
    Assignment assignment = {params, assigned, false};
    cv::usacv20::visitFields(assignment);
    if (!assignment.done)
        assigned.fail("cv::usacv20::Params has no such numeric field");
}

}  // namespace

Field::Field(const std::string& assignment_) : assignment(assignment_), value(0)
{
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos)
        fail("expected field=value");
    name = assignment.substr(0, equals);
    const std::string text = assignment.substr(equals + 1);
    char* end = 0;
    value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end)
        fail("expected a number");
}

int Field::integer() const
{
    if (value != std::floor(value) || std::abs(value) > 2147483647.)
        fail("expected an integer");
    return (int)value;
}

void Field::fail(const std::string& what) const { throw std::runtime_error("'" + assignment + "': " + what); }

std::vector<Field> parseFields(const std::string& assignments)
{
    std::vector<Field> result;
    std::istringstream in(assignments);
    std::string assignment;
    while (std::getline(in, assignment, ','))
        result.push_back(Field(assignment));
    return result;
}

void setFields(Params& params, const std::string& assignments)
{
    for (const Field& field : parseFields(assignments))
        setField(params, field);
}

}  // namespace benchmark
