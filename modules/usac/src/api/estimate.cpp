// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "api/argument_names.hpp"

// The functions estimate<NAME> of all problems, and estimateModel(), which has the problem as an
// argument.

namespace cv {
namespace usacv20 {

static const ArgumentName ONE_CAMERA[] = {{"cameraMatrix1", "cameraMatrix"}};
static const ArgumentName POSE[] = {{"points1", "objectPoints"},
                                    {"points2", "imagePoints"},
                                    {"cameraMatrix1", "cameraMatrix"},
                                    {"distCoeffs1", "distCoeffs"}};

Mat estimateModel(ProblemType problem, InputArray points1, InputArray points2, const Params& params,
                  OutputArray mask, Report& report, InputArray cameraMatrix1,
                  InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2)
{
    return Usac::create(problem, points1, points2, params, cameraMatrix1, cameraMatrix2,
                        distCoeffs1, distCoeffs2)
        ->run(mask, &report);
}

// Two functions: with and without a report.
#define USACV20_IMAGES(TYPE, NAME)                                                                 \
    Mat estimate##NAME(InputArray points1, InputArray points2, const Params& params,               \
                       OutputArray mask, Report& report)                                           \
    {                                                                                              \
        return Usac::create(TYPE, points1, points2, params)->run(mask, &report);                   \
    }                                                                                              \
    Mat estimate##NAME(InputArray points1, InputArray points2, const Params& params,               \
                       OutputArray mask)                                                           \
    {                                                                                              \
        return Usac::create(TYPE, points1, points2, params)->run(mask);                            \
    }

#define USACV20_SPACES(TYPE, NAME) USACV20_IMAGES(TYPE, NAME)

// Three functions: one with two camera matrices and a report, and two with one camera matrix for
// both images, with and without a report.
#define USACV20_CAMERAS(TYPE, NAME)                                                                \
    Mat estimate##NAME(InputArray points1, InputArray points2, InputArray cameraMatrix1,           \
                       InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2,   \
                       const Params& params, OutputArray mask, Report& report)                     \
    {                                                                                              \
        return Usac::create(TYPE, points1, points2, params, cameraMatrix1, cameraMatrix2,          \
                            distCoeffs1, distCoeffs2)                                              \
            ->run(mask, &report);                                                                  \
    }                                                                                              \
    Mat estimate##NAME(InputArray points1, InputArray points2, InputArray cameraMatrix,            \
                       const Params& params, OutputArray mask)                                     \
    {                                                                                              \
        return calling(ONE_CAMERA, [&] {                                                           \
            return Usac::create(TYPE, points1, points2, params, cameraMatrix)->run(mask);          \
        });                                                                                        \
    }                                                                                              \
    Mat estimate##NAME(InputArray points1, InputArray points2, InputArray cameraMatrix,            \
                       const Params& params, OutputArray mask, Report& report)                     \
    {                                                                                              \
        return calling(ONE_CAMERA, [&] {                                                           \
            return Usac::create(TYPE, points1, points2, params, cameraMatrix)->run(mask, &report); \
        });                                                                                        \
    }

#define USACV20_POSE(TYPE, NAME)                                                                   \
    Mat estimate##NAME(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,   \
                       InputArray distCoeffs, const Params& params, OutputArray mask,              \
                       Report& report)                                                             \
    {                                                                                              \
        return calling(POSE, [&] {                                                                 \
            return Usac::create(TYPE, objectPoints, imagePoints, params, cameraMatrix, noArray(),  \
                                distCoeffs)                                                        \
                ->run(mask, &report);                                                              \
        });                                                                                        \
    }                                                                                              \
    Mat estimate##NAME(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,   \
                       InputArray distCoeffs, const Params& params, OutputArray mask)              \
    {                                                                                              \
        return calling(POSE, [&] {                                                                 \
            return Usac::create(TYPE, objectPoints, imagePoints, params, cameraMatrix, noArray(),  \
                                distCoeffs)                                                        \
                ->run(mask);                                                                       \
        });                                                                                        \
    }

#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) USACV20_##ARGUMENTS(TYPE, NAME)
#include "problems/registry.inl.hpp"

}  // namespace usacv20
}  // namespace cv
