// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "params_fields.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include "opencv2/usac/params_fields.hpp"

namespace benchmark {

using cv::usacv20::FieldValues;
using cv::usacv20::Params;

namespace {

struct Enumerators
{
    const char* field;
    std::vector<std::string> names;
    bool flags;  //!< true: the values are 1, 2, 4, 8, ...; false: 0, 1, 2, ...
};

//! For each field of Params that has an enumeration, the names of the enumerators in the order of
//! their values, without the prefix that they share.
const std::vector<Enumerators>& enumerators()
{
    static const std::vector<Enumerators> all = {
        {"sampler", {"UNIFORM", "PROSAC", "P_NAPSAC", "NAPSAC", "IMPORTANCE"}, false},
        {"ordering", {"AUTO", "DENSITY", "INPUT_ORDER", "NONE"}, false},
        {"scoreOrder", {"LOWER_IS_BETTER", "HIGHER_IS_BETTER"}, false},
        {"neighborhood", {"GRID", "KNN", "RADIUS"}, false},
        {"thresholdType", {"GIVEN", "ESTIMATED"}, false},
        {"residual", {"STANDARD", "SYMMETRIC"}, false},
        {"quality", {"INLIERS", "MSAC", "MLESAC", "LMEDS", "MAGSAC", "MAGSAC_PLUS_PLUS"}, false},
        {"verification", {"NONE", "SPRT", "TDD"}, false},
        {"localOptimization",
         {"NONE", "GRAPH_CUT", "LO_RANSAC", "FLO_RANSAC", "SIGMA_CONSENSUS",
          "SIGMA_CONSENSUS_PLUS_PLUS", "GC_RANSAC"},
         false},
        {"termination",
         {"STANDARD", "SPRT", "P_NAPSAC", "PROSAC", "MAGSAC", "EXACT", "ORDER"},
         true},
        {"degeneracy", {"ORIENTATION", "DEGENSAC", "REPEATED"}, true},
        {"polishing", {"NONE", "LEAST_SQUARES", "REWEIGHTED", "ROBUST"}, false}};
    return all;
}

//! The form in which names are compared: "p-napsac" becomes P_NAPSAC.
std::string normalized(std::string name)
{
    for (char& c : name)
        c = c == '-' ? '_' : (char)std::toupper((unsigned char)c);
    return name;
}

//! Finds the value of a text such as "prosac" or, for a field with flags, "sprt|standard". `all`
//! gets all names of the enumeration. @return false if the text is empty, if it has an unknown
//! name, or if it has several names for a field without flags
bool valueOf(const Enumerators& of, const std::string& text, double& value, std::string& all)
{
    std::istringstream in(text);
    std::string name;
    int bits = 0, found = 0;
    for (const std::string& known : of.names)
        all += (all.empty() ? "" : ", ") + known;
    while (std::getline(in, name, '|'))
    {
        const auto known = std::find(of.names.begin(), of.names.end(), normalized(name));
        if (known == of.names.end() || (found > 0 && !of.flags))
            return false;
        const int place = (int)(known - of.names.begin());
        bits |= of.flags ? 1 << place : place;
        ++found;
    }
    value = bits;
    return found > 0;
}

//! A visitor for cv::usacv20::visitFields(): assigns a value to the numeric field of the given
//! name. `done` becomes true if there is a field of this name.
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
    template <class T>
    void operator()(const char* name, T Params::*member, const FieldValues&)
    {
        if (isIt(name))
            params.*member = (T)assigned.integer();
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
    if (!text.empty() && !*end)
        return;
    for (const Enumerators& of : enumerators())
        if (name == of.field)
        {
            std::string all;
            if (!valueOf(of, text, value, all))
                fail("expected a number or one of " + all +
                     (of.flags ? ", some of them joined by |" : ""));
            return;
        }
    fail("expected a number");
}

int Field::integer() const
{
    if (value != std::floor(value) || std::abs(value) > 2147483647.)
        fail("expected an integer");
    return (int)value;
}

void Field::fail(const std::string& what) const
{
    throw std::runtime_error("'" + assignment + "': " + what);
}

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
