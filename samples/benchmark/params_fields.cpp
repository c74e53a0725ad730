// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "params_fields.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace benchmark {

using cv::usacv20::Params;

namespace {

struct IntField
{
    const char* name;
    int Params::*member;
};

struct DoubleField
{
    const char* name;
    double Params::*member;
};

const IntField INT_FIELDS[] = {
    {"maxIterations", &Params::maxIterations},
    {"seed", &Params::seed},
    {"threads", &Params::threads},
    {"sampler", &Params::sampler},
    {"ordering", &Params::ordering},
    {"scoreOrder", &Params::scoreOrder},
    {"neighborhood", &Params::neighborhood},
    {"neighbors", &Params::neighbors},
    {"residual", &Params::residual},
    {"quality", &Params::quality},
    {"verification", &Params::verification},
    {"tddPoints", &Params::tddPoints},
    {"localOptimization", &Params::localOptimization},
    {"localIterations", &Params::localIterations},
    {"localSampleMultiple", &Params::localSampleMultiple},
    {"localSamples", &Params::localSamples},
    {"termination", &Params::termination},
    {"runnersUp", &Params::runnersUp},
    {"orderedEvery", &Params::orderedEvery},
    {"persistence", &Params::persistence},
    {"degeneracy", &Params::degeneracy},
    {"polishing", &Params::polishing},
    {"polishingSteps", &Params::polishingSteps},
};

const DoubleField DOUBLE_FIELDS[] = {
    {"threshold", &Params::threshold},           {"confidence", &Params::confidence},
    {"neighborRadius", &Params::neighborRadius}, {"reach", &Params::reach},
    {"widestReach", &Params::widestReach},       {"spatialWeight", &Params::spatialWeight},
    {"relaxation", &Params::relaxation},         {"significance", &Params::significance},
};

void setField(Params& params, const Field& assigned)
{
    for (const DoubleField& field : DOUBLE_FIELDS)
        if (assigned.name == field.name)
        {
            params.*field.member = assigned.value;
            return;
        }
    for (const IntField& field : INT_FIELDS)
        if (assigned.name == field.name)
        {
            params.*field.member = assigned.integer();
            return;
        }
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
