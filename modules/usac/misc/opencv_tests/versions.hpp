// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_VERSIONS_HPP
#define OPENCV_USACV20_VERSIONS_HPP

#include <string>

/** True if a line of the list of differences applies to a version of OpenCV.

@param condition `>=4.10` (this version and later ones), `<4.10` (earlier ones), or empty (all
versions). Numbers are compared one by one, so 4.10 is later than 4.6. Any other text raises a
cv::Exception.
@param version version of OpenCV with at least two numbers, such as `4.6.0` */
bool isForVersion(const std::string& condition, const std::string& version);

#endif
