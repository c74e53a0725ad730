// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MODULE_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_MODULE_METHOD_HPP

#include "method.hpp"
#include "method_name.hpp"
#include "opencv2/usac.hpp"

namespace benchmark {

/** A flag or a preset of this module.

A flag is run through its cv::usacv20::Params, because the function with the flag takes no seed; the
estimate and the time are the same. The report comes from a second run, which must give the same
model. With scores and a preset that relies on the order of the points, the scores give the order.
*/
class ModuleMethod : public Method
{
public:
    //! @param name what stands behind its base changes the parameters. @param params those of the
    //! base.
    ModuleMethod(const MethodName& name, const cv::usacv20::Params& params);

    bool solves(ProblemType) const CV_OVERRIDE { return true; }
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    void tell(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    //! Those of the run that is prepared.
    const cv::usacv20::Params& parameters() const { return params; }

    //! Params::initialModel of the run that is prepared.
    void beginWith(const cv::Mat& model);

    //! Makes the estimator of the run that is prepared; it can be run once.
    virtual cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair) const;

    //! @param name of a flag, or of a preset behind "preset:". An unknown one raises
    //! std::runtime_error.
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
