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

A flag is run through its cv::usacv20::Params, because the function that takes the flag takes no
seed; estimate and time are the same. The report comes from a second run, which must give the same
model. With `+scores` and a preset that relies on the order of the points, this order follows from
the scores.
*/
class ModuleMethod : public Method
{
public:
    //! @param name may have `+scores` and `{fields}`, which change the parameters. @param params
    //! those of the base name.
    ModuleMethod(const MethodName& name, const cv::usacv20::Params& params);

    bool solves(ProblemType) const CV_OVERRIDE { return true; }
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    void tell(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    //! The parameters of the prepared run.
    const cv::usacv20::Params& parameters() const { return params; }

    //! Sets Params::initialModel of the prepared run.
    void beginWith(const cv::Mat& model);

    //! Makes the estimator of the prepared run; it can be run once.
    virtual cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair) const;

    //! @param name a flag, or "preset:" and a preset. An unknown name raises std::runtime_error.
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
