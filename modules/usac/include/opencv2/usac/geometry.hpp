// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GEOMETRY_HPP
#define OPENCV_USACV20_GEOMETRY_HPP

// Includes the header of the OpenCV module that has findHomography, solvePnPRansac and similar
// functions: `calib3d` of OpenCV 4, `geometry` of OpenCV 5. Files of this module include it only
// through this header.

#include "opencv2/core/version.hpp"

#if CV_VERSION_MAJOR >= 5
#include "opencv2/geometry.hpp"
#else
#include "opencv2/calib3d.hpp"
#endif

#endif
