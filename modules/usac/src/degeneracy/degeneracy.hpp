// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DEGENERACY_HPP
#define OPENCV_USACV20_DEGENERACY_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! H: orientation of the sample, near-singular models; see HomographyOrientation.
Ptr<Degeneracy> createHomographyOrientation();
//! F, E: see OrientedEpipolar.
Ptr<Degeneracy> createOrientedEpipolar();
//! E: scenes dominated by a plane, see PlanarMotion.
Ptr<Degeneracy> createPlanarMotion();
//! F: samples dominated by a plane, see Degensac.
Ptr<Degeneracy> createDegensac();

//! H: see RepeatedPoints.
Ptr<Degeneracy> createRepeatedPoints();
//! F, E: see SharedPoints.
Ptr<Degeneracy> createSharedPoints(const Correspondences& points);

} // namespace usacv20
} // namespace cv

#endif
