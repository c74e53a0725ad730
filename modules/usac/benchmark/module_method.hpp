// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MODULE_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_MODULE_METHOD_HPP

#include "method.hpp"
#include "method_name.hpp"
#include "opencv2/usac.hpp"

namespace benchmark {

/** A method that runs a flag or a preset of this module.

A flag is run through its cv::usacv20::Params, because the function that takes a flag has no
argument for the seed; estimate and time are the same. The report comes from a second run, which
must give the same model. With `+scores`, Params::ordering is ORDERING_AUTO, so that the points are
ordered by their scores, even by a preset that expects sorted points.
*/
class ModuleMethod : public Method
{
public:
    //! @param name the base name, with or without `+scores` and `{fields}`, which change `params`
    //! @param params the parameters that the base name stands for
    ModuleMethod(const MethodName& name, const cv::usacv20::Params& params);

    bool solves(ProblemType) const CV_OVERRIDE { return true; }
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    void tell(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    //! Sets Params::initialModel of the prepared run.
    void beginWith(const cv::Mat& model);

    //! Makes the estimator of the prepared run.
    virtual cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair) const;

    //! The parameters of a base name: a flag, or "preset:" followed by a preset. An unknown name
    //! raises std::runtime_error.
    static cv::usacv20::Params paramsOf(const std::string& name);
    static std::string names();

private:
    cv::usacv20::Params base, params;
    std::string fields;
    bool useScores;
    ProblemType problem;
};

}  // namespace benchmark

#endif
