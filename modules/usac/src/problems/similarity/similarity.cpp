// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/similarity/similarity.hpp"
#include "problems/similarity/similarity_parameterization.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

Ptr<Problem> createSimilarity2DProblem()
{
    // the time was measured together with the cost of H
    const PlaneMapParts parts = {"similarity", 120, false, createSimilarity2Solver,
                                 createSimilarityLeastSquares};
    return makePtr<PlaneMap<SimilarityParameterization>>(parts);
}

}  // namespace usacv20
}  // namespace cv
