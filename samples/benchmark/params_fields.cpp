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
    { "maxIterations", &Params::maxIterations },
    { "seed", &Params::seed },
    { "threads", &Params::threads },
    { "sampler", &Params::sampler },
    { "prior", &Params::prior },
    { "scoreOrder", &Params::scoreOrder },
    { "neighbourhood", &Params::neighbourhood },
    { "neighbours", &Params::neighbours },
    { "residual", &Params::residual },
    { "quality", &Params::quality },
    { "verification", &Params::verification },
    { "tddPoints", &Params::tddPoints },
    { "localOptimization", &Params::localOptimization },
    { "localIterations", &Params::localIterations },
    { "localSampleMultiple", &Params::localSampleMultiple },
    { "localSamples", &Params::localSamples },
    { "termination", &Params::termination },
    { "runnersUp", &Params::runnersUp },
    { "orderedEvery", &Params::orderedEvery },
    { "persistence", &Params::persistence },
    { "degeneracy", &Params::degeneracy },
    { "polishing", &Params::polishing },
    { "polishingSteps", &Params::polishingSteps },
};

const DoubleField DOUBLE_FIELDS[] = {
    { "threshold", &Params::threshold },
    { "confidence", &Params::confidence },
    { "neighbourRadius", &Params::neighbourRadius },
    { "reach", &Params::reach },
    { "widestReach", &Params::widestReach },
    { "spatialWeight", &Params::spatialWeight },
    { "relaxation", &Params::relaxation },
    { "significance", &Params::significance },
};

void fail(const std::string& assignment, const std::string& what)
{
    throw std::runtime_error("'" + assignment + "': " + what);
}

void setField(Params& params, const std::string& assignment)
{
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos)
        fail(assignment, "expected field=value");
    const std::string name = assignment.substr(0, equals), text = assignment.substr(equals + 1);
    char* end = 0;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end)
        fail(assignment, "expected a number");

    for (const DoubleField& field : DOUBLE_FIELDS)
        if (name == field.name)
        {
            params.*field.member = value;
            return;
        }
    for (const IntField& field : INT_FIELDS)
        if (name == field.name)
        {
            if (value != std::floor(value) || std::abs(value) > 2147483647.)
                fail(assignment, "expected an integer");
            params.*field.member = (int)value;
            return;
        }
    fail(assignment, "cv::usacv20::Params has no such numeric field");
}

} // namespace

void setFields(Params& params, const std::string& assignments)
{
    std::istringstream in(assignments);
    std::string assignment;
    while (std::getline(in, assignment, ','))
        setField(params, assignment);
}

} // namespace benchmark
