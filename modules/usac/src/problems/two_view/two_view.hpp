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
//! Adds those checks of a set of flags that maps of points have, which are these two. Raises
//! cv::Exception if #DEGENERACY_DEGENSAC is set, unless all flags are.
void createChecksOfMaps(int flags, const String& problem,
                        std::vector<Ptr<Degeneracy>>& degeneracies);
//! F, E: see SharedPoints.
Ptr<Degeneracy> createSharedPoints();

//! Frobenius norm, summed in the order of cv::norm of OpenCV 4, which OpenCV 5 has changed.
inline double frobeniusNorm(const Matx33d& m)
{
    const double* const v = m.val;
    double sum = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    sum += v[4] * v[4] + v[5] * v[5] + v[6] * v[6] + v[7] * v[7];
    return std::sqrt(sum + v[8] * v[8]);
}

//! Scales a model to unit Frobenius norm. False if it is zero or not finite.
inline bool toUnitNorm(Matx33d& model)
{
    const double size = frobeniusNorm(model);
    if (!(size > 0 && size <= DBL_MAX))
        return false;
    model *= 1 / size;
    return true;
}

}  // namespace usacv20
}  // namespace cv

#endif
