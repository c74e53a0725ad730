// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/affinity/affinity_parameterization.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

Ptr<Problem> createAffinity2DProblem()
{
    // the time was measured together with the cost of H
    const PlaneMapParts parts = {"affinity", 150, false, createAffinity3Solver,
                                 createAffinityLeastSquares};
    return makePtr<PlaneMap<AffinityParameterization>>(parts);
}

}  // namespace usacv20
}  // namespace cv
