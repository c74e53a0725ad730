// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "components_method.hpp"

#include <stdexcept>

namespace benchmark {

ComponentsMethod::ComponentsMethod(const MethodName& name, const cv::usacv20::Params& params_,
                                   const ComponentChange& change_, const ProblemSet& problems_)
    : ModuleMethod(name, params_), change(change_), problems(problems_)
{}

void ComponentsMethod::run(const ImagePair& pair, Estimate& estimate)
{
    estimate.model = estimator(pair)->run(estimate.mask);
}

cv::Ptr<cv::usacv20::Usac> ComponentsMethod::estimator(const ImagePair& pair) const
{
    const cv::Ptr<cv::usacv20::Usac> usac = ModuleMethod::estimator(pair);
    change(*usac);
    return usac;
}

MethodFactory withComponents(const cv::usacv20::Params& params, const ComponentChange& change,
                             const ProblemSet& problems)
{
    if (!change)
        throw std::runtime_error("withComponents: the change is empty");
    cv::usacv20::Params base = params;
    base.scores.clear();  // scores belong to a single pair; with `+scores`, each run sets its own
    return [=](const MethodName& name) -> cv::Ptr<Method> {
        return cv::makePtr<ComponentsMethod>(name, base, change, problems);
    };
}

}  // namespace benchmark
