// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TWO_VIEW_HPP
#define OPENCV_USACV20_TWO_VIEW_HPP

#include <cfloat>
#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Creates the check of the oriented epipolar constraint for F and E, see OrientedEpipolar.
Ptr<Degeneracy> createOrientedEpipolar();
//! Creates the check for matches that share a point and for repeated matches, for problems that map
//! points to points, see RepeatedPoints.
Ptr<Degeneracy> createRepeatedPoints();
//! Creates the check for matches of many points to one small region, for problems that map points
//! to points, see CrowdedPlaces.
Ptr<Degeneracy> createCrowdedPlaces();
//! If `flags` contains #DEGENERACY_REPEATED, adds RepeatedPoints and CrowdedPlaces, the only checks
//! for affine maps, absolute poses and motions of space. Raises cv::Exception, whose message
//! contains the name `problem`, if #DEGENERACY_DEGENSAC is set but not all flags are set.
void createChecksOfMaps(int flags, const String& problem,
                        std::vector<Ptr<Degeneracy>>& degeneracies);
//! Creates the check for matches that share a point (up to noise), for F and E, see SharedPoints.
Ptr<Degeneracy> createSharedPoints();

}  // namespace usacv20
}  // namespace cv

#endif
