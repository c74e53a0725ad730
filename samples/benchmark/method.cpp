// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "method.hpp"

#include <stdexcept>
#include "module_method.hpp"
#include "opencv_method.hpp"

namespace benchmark {

namespace {

//! Cuts `+scores` off the end of a name or from before `{`. @return whether it was there.
bool cutScores(std::string& name)
{
    const std::string suffix = "+scores";
    const size_t found = name.find(suffix), next = found + suffix.size();
    if (found == std::string::npos || (next < name.size() && name[next] != '{'))
        return false;
    name.erase(found, suffix.size());
    return true;
}

//! Cuts `{...}` off the end of a name. @return what is in between, empty if there is none.
std::string cutFields(std::string& name)
{
    const size_t open = name.find('{');
    if (open == std::string::npos)
        return std::string();
    if (name[name.size() - 1] != '}')
        throw std::runtime_error(name + ": expected '}' at the end");
    const std::string fields = name.substr(open + 1, name.size() - open - 2);
    name.resize(open);
    return fields;
}

} // namespace

Settings::Settings(ProblemType problem_)
    : problem(problem_), threshold(problem_ == cv::usacv20::HOMOGRAPHY ? 2 : 1), confidence(0.99),
      maxIterations(problem_ == cv::usacv20::HOMOGRAPHY ? 10000 : 1000), seed(1)
{
}

cv::Ptr<Method> createMethod(const std::string& name)
{
    std::string base = name;
    const bool scores = cutScores(base);
    const std::string fields = cutFields(base);
    if (base.compare(0, 3, "cv:") != 0)
        return cv::makePtr<ModuleMethod>(name, base, fields, scores);
    if (!fields.empty())
        throw std::runtime_error(name + ": OpenCV's flags have no fields");
    return cv::makePtr<OpenCVMethod>(name, base.substr(3), scores);
}

std::string knownMethods()
{
    return ModuleMethod::names() + ", " + OpenCVMethod::names();
}

} // namespace benchmark
