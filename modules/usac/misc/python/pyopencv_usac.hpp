// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYOPENCV_USAC_HPP
#define OPENCV_USACV20_PYOPENCV_USAC_HPP

#ifdef HAVE_OPENCV_USAC

// The generator of the bindings writes some types of a nested namespace with '_' in place of '::'.
typedef cv::usacv20::Params usacv20_Params;
typedef cv::usacv20::Report usacv20_Report;

#endif

#endif
