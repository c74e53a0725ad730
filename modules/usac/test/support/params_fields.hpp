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

template <class T>
struct NamedField
{
    const char* name;
    T Params::*member;
    FieldValues values;
};

//! The fields of Params of the types int and double, and the names of all fields, each list in the
//! order of cv::usacv20::visitFields.
struct Fields
{
    std::vector<NamedField<int>> ints;
    std::vector<NamedField<double>> doubles;
    std::vector<std::string> names;  //!< of all fields, whatever their type

    Fields() { cv::usacv20::visitFields(*this); }

    void operator()(const char* name, int Params::*member, const FieldValues& values)
    {
        ints.push_back(NamedField<int>{name, member, values});
        names.push_back(name);
    }
    void operator()(const char* name, double Params::*member, const FieldValues& values)
    {
        doubles.push_back(NamedField<double>{name, member, values});
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
