// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLERS_HPP
#define OPENCV_USACV20_SAMPLERS_HPP

#include "opencv2/usac/components.hpp"
#include "samplers/growth.hpp"

namespace cv {
namespace usacv20 {

//! All samples equally likely, see UniformSampler.
Ptr<Sampler> createUniformSampler();
//! The best points first, see ProsacSampler.
Ptr<Sampler> createProsacSampler();
//! Neighbours of the best points first, see PNapsacSampler.
Ptr<Sampler> createPNapsacSampler();

} // namespace usacv20
} // namespace cv

#endif
