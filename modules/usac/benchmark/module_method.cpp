// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "module_method.hpp"

#include <stdexcept>
#include "params_fields.hpp"
#include "problems/problem_kind.hpp"

namespace benchmark {

using cv::usacv20::Params;

namespace {

struct Flag
{
    const char* name;
    cv::UsacV20Method value;
};

const Flag FLAGS[] = {
    {"USACV20", cv::USACV20},
    {"USACV20_FAST", cv::USACV20_FAST},
    {"USACV20_ACCURATE", cv::USACV20_ACCURATE},
    {"USACV20_PROSAC", cv::USACV20_PROSAC},
    {"USACV20_MAGSAC", cv::USACV20_MAGSAC},
    {"USACV20_PARALLEL", cv::USACV20_PARALLEL},
    {"USACV20_AUTO", cv::USACV20_AUTO},
};

struct Preset
{
    const char* name;
    Params (*make)();
};

const Preset PRESETS[] = {
    {"preset:usacV20", &Params::usacV20},
    {"preset:fast", &Params::fast},
    {"preset:accurate", &Params::accurate},
    {"preset:sorted", &Params::sorted},
    {"preset:parallel", &Params::parallel},
    {"preset:automatic", &Params::automatic},
    {"preset:ransac", &Params::ransac},
    {"preset:msac", &Params::msac},
    {"preset:lmeds", &Params::lmeds},
    {"preset:mlesac", &Params::mlesac},
    {"preset:prosac", &Params::prosac},
    {"preset:loRansac", &Params::loRansac},
    {"preset:floRansac", &Params::floRansac},
    {"preset:gcRansac", &Params::gcRansac},
    {"preset:usac2013", &Params::usac2013},
    {"preset:paper", &Params::paper},
    {"preset:trustedScores", &Params::trustedScores},
    {"preset:magsac", &Params::magsac},
    {"preset:magsacPlusPlus", &Params::magsacPlusPlus},
};

}  // namespace

ModuleMethod::ModuleMethod(const MethodName& name, const Params& params_)
    : Method(name.full), base(params_), fields(name.fields), useScores(name.scores),
      problem(cv::usacv20::HOMOGRAPHY)
{
    if (useScores)
        base.ordering = cv::usacv20::ORDERING_AUTO;
    setFields(base, fields);  // so that wrong field names and values are reported before any run
    Params checked = base;
    if (useScores)
        checked.scores.assign(1, 1.f);  // stands for the pair's scores; some options need scores
    checked.check();
}

void ModuleMethod::prepare(const ImagePair& pair, const Settings& settings)
{
    problem = settings.problem;
    params = base;
    params.threshold = settings.threshold;
    params.confidence = settings.confidence;
    params.maxIterations = settings.maxIterations;
    params.seed = settings.seed;
    if (useScores)
        params.scores = pair.scores;
    setFields(params, fields);  // again: fields in the method's name override `settings`
}

void ModuleMethod::run(const ImagePair& pair, Estimate& estimate)
{
    kindOf(problem).callModule(pair, params, estimate);
}

void ModuleMethod::tell(const ImagePair& pair, Estimate& estimate)
{
    cv::usacv20::Report report;
    cv::Mat mask, model = estimator(pair)->run(mask, &report);
    if (model.empty() != estimate.model.empty() ||
        (!model.empty() && cv::norm(model, estimate.model, cv::NORM_INF) != 0))
        throw std::runtime_error("the same call gave another model");
    estimate.iterations = report.iterations;
}

void ModuleMethod::beginWith(const cv::Mat& model)
{
    model.reshape(1, 1).convertTo(params.initialModel, CV_64F);
}

cv::Ptr<cv::usacv20::Usac> ModuleMethod::estimator(const ImagePair& pair) const
{
    return kindOf(problem).estimator(pair, params);
}

Params ModuleMethod::paramsOf(const std::string& name)
{
    for (const Flag& flag : FLAGS)
        if (name == flag.name)
            return Params::fromMethod(flag.value);
    for (const Preset& preset : PRESETS)
        if (name == preset.name)
            return preset.make();
    throw std::runtime_error(name + ": no such method; there are " + knownMethods());
}

std::string ModuleMethod::names()
{
    std::string result;
    for (const Flag& flag : FLAGS)
        result += (result.empty() ? "" : ", ") + std::string(flag.name);
    for (const Preset& preset : PRESETS)
        result += ", " + std::string(preset.name);
    return result;
}

}  // namespace benchmark
