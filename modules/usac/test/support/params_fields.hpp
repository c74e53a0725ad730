// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PARAMS_FIELDS_HPP
#define OPENCV_USACV20_TEST_PARAMS_FIELDS_HPP

#include <string>
#include <vector>
#include "opencv2/usac/params_fields.hpp"

namespace opencv_test {

using cv::usacv20::FieldValues;
using cv::usacv20::Params;

struct NamedField
{
    const char* name;
    FieldValues values;
};

//! Assigns a number to the field of the given name, whose type is not a list.
class Assignment
{
public:
    Assignment(Params& params_, const std::string& name, double value_)
        : params(params_), assigned(name), value(value_)
    {
        cv::usacv20::visitFields(*this);
    }
    template <class T>
    void operator()(const char* name, T Params::*member, const FieldValues&)
    {
        if (assigned == name)
            params.*member = (T)value;
    }
    template <class T>
    void operator()(const char*, std::vector<T> Params::*, const FieldValues&)
    {}

private:
    Params& params;
    const std::string assigned;
    const double value;
};

//! The fields of Params of the type double, those that are integers or enumerators, and the names
//! of all fields, each list in the order of cv::usacv20::visitFields.
struct Fields
{
    std::vector<NamedField> ints, doubles;
    std::vector<std::string> names;  //!< of all fields, whatever their type

    Fields() { cv::usacv20::visitFields(*this); }

    template <class T>
    void operator()(const char* name, T Params::*, const FieldValues& values)
    {
        ints.push_back(NamedField{name, values});
        names.push_back(name);
    }
    void operator()(const char* name, double Params::*, const FieldValues& values)
    {
        doubles.push_back(NamedField{name, values});
        names.push_back(name);
    }
    template <class T>
    void operator()(const char* name, std::vector<T> Params::*, const FieldValues&)
    {
        names.push_back(name);
    }

    //! Names of the fields in which a and b differ, each followed by a space.
    static std::string difference(const Params& a, const Params& b)
    {
        Comparison comparison = {a, b, ""};
        cv::usacv20::visitFields(comparison);
        return comparison.different;
    }

private:
    struct Comparison
    {
        const Params &a, &b;
        std::string different;
        template <class T>
        void operator()(const char* name, T Params::*member, const FieldValues&)
        {
            if (a.*member != b.*member)
                different += std::string(name) + " ";
        }
    };
};

}  // namespace opencv_test

#endif
