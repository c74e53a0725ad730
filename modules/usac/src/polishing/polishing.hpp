// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POLISHING_HPP
#define OPENCV_USACV20_POLISHING_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Work per point of a fit that runs to convergence, in point tests of 2 ns, the unit of Watch:
//! 100 ns per point if there are a million points. The value only affects how late a time limit
//! ends a run.
constexpr double FIT_WORK = 50;

//! Creates the polisher that makes least-squares fits to all inliers, see LeastSquaresPolisher.
Ptr<Polisher> createLeastSquaresPolisher();
//! Creates the polisher with the weights of MAGSAC++, see ReweightedPolisher.
Ptr<Polisher> createReweightedPolisher();
//! Creates the polisher that minimizes Tukey's biweight, see BiweightPolisher.
Ptr<Polisher> createBiweightPolisher();
//! Creates the polisher of #POLISHING_ROBUST, see RobustPolisher.
Ptr<Polisher> createRobustPolisher();

}  // namespace usacv20
}  // namespace cv

#endif
