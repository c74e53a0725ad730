// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_VERIFICATION_HPP
#define OPENCV_USACV20_VERIFICATION_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates Wald's sequential probability ratio test, see SprtVerifier.
Ptr<Verifier> createSprtVerifier(const SampleCost& cost);
//! Creates the T(d,d) test with d = `points`, see TddVerifier.
Ptr<Verifier> createTddVerifier(int points);

}  // namespace usacv20
}  // namespace cv

#endif
