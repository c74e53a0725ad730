// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "estimator_method.hpp"

#include "arguments.hpp"
#include "params_fields.hpp"
#include "problems/problem_kind.hpp"

namespace benchmark {

EstimatorMethod::EstimatorMethod(const MethodName& name, const Estimator& estimator_,
                                 const EstimatorTraits& traits_)
    : Method(name.full), estimator(estimator_), traits(traits_), fields(name.fields),
      useScores(name.scores)
{
    require(traits.takesScores || !useScores, name.full + ": takes no scores");
    setFields();  // so that wrong field names and values are reported before any run
}

void EstimatorMethod::setFields()
{
    Settings& settings = task.settings;
    task.fields = traits.fields;
    for (const Field& field : parseFields(fields))
    {
        if (field.name == "threshold")
            settings.threshold = field.value;
        else if (field.name == "confidence")
            settings.confidence = field.value;
        else if (field.name == "maxIterations")
            settings.maxIterations = field.integer();
        else if (field.name == "seed")
            settings.seed = field.integer();
        else if (task.fields.count(field.name))
            task.fields[field.name] = field.value;
        else
        {
            std::string known = "threshold, confidence, maxIterations, seed";
            for (const std::pair<const std::string, double>& own : traits.fields)
                known += ", " + own.first;
            field.fail(name() + " has no such field; there are " + known);
        }
    }
    require(settings.threshold > 0, name() + ": threshold: expected a number above 0");
    require(settings.maxIterations > 0, name() + ": maxIterations: expected a number above 0");
    require(settings.confidence > 0 && settings.confidence < 1,
            name() + ": confidence: expected a number between 0 and 1");
}

void EstimatorMethod::prepare(const ImagePair& pair, const Settings& settings)
{
    task.settings = settings;
    setFields();  // again: fields in the method's name override `settings`
    task.points1 = pair.points1;
    task.points2 = pair.points2;
    task.spacePoints2 = pair.spacePoints2;
    task.scores = useScores ? pair.scores : std::vector<float>();
    const ProblemKind& kind = kindOf(settings.problem);
    task.objectPoints = pair.objectPoints;
    task.distortion = pair.distortion;
    task.K1 = kind.hasCamera1() ? pair.K1 : cv::Matx33d::eye();
    task.K2 = kind.hasCamera2() ? pair.K2 : cv::Matx33d::eye();
}

void EstimatorMethod::run(const ImagePair&, Estimate& estimate) { estimate = estimator(task); }

void EstimatorMethod::tell(const ImagePair& pair, Estimate& estimate)
{
    const cv::Mat &model = estimate.model, &mask = estimate.mask;
    const cv::Size size = kindOf(task.settings.problem).modelSize;
    require(model.empty() || (model.type() == CV_64F && model.size() == size),
            cv::format("expected a model of %d x %d doubles or none", size.height, size.width));
    require(mask.empty() ||
                (mask.type() == CV_8U && (int)mask.total() == pair.size() && mask.isContinuous()),
            "expected a mask with a byte for each correspondence or none");
}

MethodFactory wholeEstimator(const Estimator& estimator, const EstimatorTraits& traits)
{
    require((bool)estimator, "wholeEstimator: the function is empty");
    return [=](const MethodName& name) -> cv::Ptr<Method> {
        return cv::makePtr<EstimatorMethod>(name, estimator, traits);
    };
}

}  // namespace benchmark
