// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "method.hpp"

#include <stdexcept>
#include "module_method.hpp"
#include "opencv_method.hpp"
#include "problems/problem_kind.hpp"
#include "registry.hpp"

namespace benchmark {

Settings::Settings(ProblemType problem_)
    : problem(problem_), threshold(kindOf(problem_).threshold), confidence(0.99),
      maxIterations(kindOf(problem_).maxIterations), seed(1)
{}

cv::Ptr<Method> createMethod(const std::string& name)
{
    const MethodName parts(name);
    if (isCustom(parts.base))
        return createCustom(parts);
    if (parts.base.compare(0, 3, "cv:") != 0)
        return cv::makePtr<ModuleMethod>(parts, ModuleMethod::paramsOf(parts.base));
    if (!parts.fields.empty())
        throw std::runtime_error(name + ": OpenCV's flags have no fields");
    return cv::makePtr<OpenCVMethod>(name, parts.base.substr(3), parts.scores);
}

std::string knownMethods()
{
    const std::string custom = customMethods();
    return ModuleMethod::names() + ", " + OpenCVMethod::names() +
           (custom.empty() ? "" : ", " + custom);
}

}  // namespace benchmark
