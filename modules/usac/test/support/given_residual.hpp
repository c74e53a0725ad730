// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_GIVEN_RESIDUAL_HPP
#define OPENCV_USACV20_TEST_GIVEN_RESIDUAL_HPP

#include "opencv2/usac.hpp"

namespace opencv_test {

using namespace cv::usacv20;

//! A residual whose squared errors are set by the test and do not depend on the model.
class GivenResidual : public Residual
{
public:
    void squaredErrors(const Correspondences&, const Model&, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        std::copy(given.begin() + begin, given.begin() + end, errors);
    }
    void squaredErrors(const Model&, const double* const*, int count,
                       double* errors) const CV_OVERRIDE
    {
        std::copy(given.begin(), given.begin() + count, errors);
    }

    std::vector<float> given;
};

}  // namespace opencv_test

#endif
