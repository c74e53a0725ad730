// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PRECOMP_HPP
#define OPENCV_USACV20_PRECOMP_HPP

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>
#include <vector>

#include "opencv2/core.hpp"
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac.hpp"

#endif
