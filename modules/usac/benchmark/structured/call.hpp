// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_CALL_HPP
#define OPENCV_USACV20_BENCHMARK_CALL_HPP

#include "method.hpp"

namespace benchmark {

//! One call of a method with its results.
struct Call
{
    //! Runs the method. A cv::Exception counts as no model.
    //! @param initial Params::initialModel, used for methods of this module only; empty: none
    Call(Method& method, const ImagePair& pair, const Settings& settings,
         const cv::Mat& initial = cv::Mat());

    Estimate estimate;
    double cpuUs;  //!< processor time, microseconds
    bool limited;  //!< true: stopped by Settings::maxIterations; false for methods of calib3d
};

}  // namespace benchmark

#endif
