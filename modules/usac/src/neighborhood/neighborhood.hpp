// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NEIGHBORHOOD_HPP
#define OPENCV_USACV20_NEIGHBORHOOD_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Creates a multi-layer grid in the joint space of the columns, see GridNeighborhood.
Ptr<Neighborhood> createGridNeighborhood(int columns);
//! Creates a graph of nearest neighbors, see FlannNeighborhood.
//! @param neighbors number of neighbors of a point in the finest layer
Ptr<Neighborhood> createKnnNeighborhood(int neighbors);
//! Creates a graph of the neighbors within a radius, see FlannNeighborhood.
//! @param radius radius of the finest layer, in pixels
Ptr<Neighborhood> createRadiusNeighborhood(double radius);

}  // namespace usacv20
}  // namespace cv

#endif
