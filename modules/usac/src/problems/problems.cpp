// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/absolute_pose/absolute_pose.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/essential/essential.hpp"
#include "problems/fundamental/fundamental.hpp"
#include "problems/homography/homography.hpp"
#include "problems/problems.hpp"
#include "problems/rigid_motion/rigid_motion.hpp"
#include "problems/similarity/similarity.hpp"

namespace cv {
namespace usacv20 {

Ptr<Problem> createProblem(ProblemType type, InputArray cameraMatrix1, InputArray cameraMatrix2,
                           InputArray distCoeffs1, InputArray distCoeffs2)
{
    switch (type)
    {
    case HOMOGRAPHY: return createHomographyProblem();
    case FUNDAMENTAL: return createFundamentalProblem();
    case AFFINITY: return createAffinityProblem();
    case SIMILARITY: return createSimilarityProblem();
    case ESSENTIAL:
        return createEssentialProblem(cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2);
    case ABSOLUTE_POSE: return createAbsolutePoseProblem(cameraMatrix1, distCoeffs1);
    case RIGID_3D: return createRigid3DProblem();
    case SIMILARITY_3D: return createSimilarity3DProblem();
    }
    CV_Error_(Error::StsBadArg, ("problem: one of ProblemType is expected, not %d", (int)type));
}

}  // namespace usacv20
}  // namespace cv
