// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FACTORY_HPP
#define OPENCV_USACV20_FACTORY_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates the components that the options select. A new variant of a component needs a source
//! file, an enumerator in params.hpp and a line in factory.cpp.
//! @param points the points, for Correspondences::noise, see residualWithNoise()
Components createComponents(const Problem& problem, const Params& params,
                            const Correspondences& points);

}  // namespace usacv20
}  // namespace cv

#endif
