// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TWO_VIEW_HPP
#define OPENCV_USACV20_TWO_VIEW_HPP

#include <cfloat>
#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! F, E: see OrientedEpipolar.
Ptr<Degeneracy> createOrientedEpipolar();
//! Maps of points: repeated matches, see RepeatedPoints.
Ptr<Degeneracy> createRepeatedPoints();
//! Maps of points: matches of many points to one place, see CrowdedPlaces.
Ptr<Degeneracy> createCrowdedPlaces();
//! Adds the checks that maps of points have, which are the two above, if `flags` ask for them.
//! Raises cv::Exception if #DEGENERACY_DEGENSAC is set, unless all flags are.
void createChecksOfMaps(int flags, const String& problem,
                        std::vector<Ptr<Degeneracy>>& degeneracies);
//! F, E: see SharedPoints.
Ptr<Degeneracy> createSharedPoints();

}  // namespace usacv20
}  // namespace cv

#endif
