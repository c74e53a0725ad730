// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NEIGHBOURHOOD_HPP
#define OPENCV_USACV20_NEIGHBOURHOOD_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Multi-layer grid in the 4-D joint space, see GridNeighbourhood.
Ptr<Neighbourhood> createGridNeighbourhood();
//! Nearest neighbours, see FlannNeighbourhood. @param neighbours their number in the finest layer
Ptr<Neighbourhood> createKnnNeighbourhood(int neighbours);
//! Points within a radius, see FlannNeighbourhood. @param radius pixels, of the finest layer
Ptr<Neighbourhood> createRadiusNeighbourhood(double radius);

} // namespace usacv20
} // namespace cv

#endif
