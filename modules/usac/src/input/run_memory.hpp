// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUN_MEMORY_HPP
#define OPENCV_USACV20_RUN_MEMORY_HPP

#include "opencv2/usac/params.hpp"

namespace cv {
namespace usacv20 {

//! Bytes of arena memory that a run with this many points usually needs.
size_t runMemory(int points, const Params& params);

}  // namespace usacv20
}  // namespace cv

#endif
