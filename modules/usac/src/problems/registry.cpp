// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/registry.hpp"

namespace cv {
namespace usacv20 {

// Declares the factories, which are defined in the folders of the problems.
#define USACV20_IMAGES(NAME) Ptr<Problem> create##NAME##Problem();
#define USACV20_SPACES(NAME) Ptr<Problem> create##NAME##Problem();
#define USACV20_CAMERAS(NAME)                                                                      \
    Ptr<Problem> create##NAME##Problem(InputArray cameraMatrix1, InputArray cameraMatrix2,         \
                                       InputArray distCoeffs1, InputArray distCoeffs2);
#define USACV20_POSE(NAME)                                                                         \
    Ptr<Problem> create##NAME##Problem(InputArray cameraMatrix, InputArray distCoeffs);
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) USACV20_##ARGUMENTS(NAME)
#include "problems/registry.inl.hpp"

Ptr<Problem> createProblem(ProblemType type, InputArray cameraMatrix1, InputArray cameraMatrix2,
                           InputArray distCoeffs1, InputArray distCoeffs2)
{
#define USACV20_IMAGES ()
#define USACV20_SPACES ()
#define USACV20_CAMERAS (cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2)
#define USACV20_POSE (cameraMatrix1, distCoeffs1)
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS)                                             \
    case TYPE: return create##NAME##Problem USACV20_##ARGUMENTS;
    switch (type)
    {
#include "problems/registry.inl.hpp"
    }
    CV_Error_(Error::StsBadArg, ("problem: one of ProblemType is expected, not %d", (int)type));
}

}  // namespace usacv20
}  // namespace cv
