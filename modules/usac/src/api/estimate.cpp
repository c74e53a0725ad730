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

Mat estimateHomography(InputArray points1, InputArray points2, const Params& params,
                       OutputArray mask, Report& report)
{
    return Usac::create(HOMOGRAPHY, points1, points2, params)->run(mask, &report);
}

Mat estimateHomography(InputArray points1, InputArray points2, const Params& params,
                       OutputArray mask)
{
    return Usac::create(HOMOGRAPHY, points1, points2, params)->run(mask);
}

Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params,
                        OutputArray mask, Report& report)
{
    return Usac::create(FUNDAMENTAL, points1, points2, params)->run(mask, &report);
}

Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params,
                        OutputArray mask)
{
    return Usac::create(FUNDAMENTAL, points1, points2, params)->run(mask);
}

Mat estimateAffinity2D(InputArray points1, InputArray points2, const Params& params,
                       OutputArray mask, Report& report)
{
    return Usac::create(AFFINITY, points1, points2, params)->run(mask, &report);
}

Mat estimateAffinity2D(InputArray points1, InputArray points2, const Params& params,
                       OutputArray mask)
{
    return Usac::create(AFFINITY, points1, points2, params)->run(mask);
}

Mat estimateSimilarity2D(InputArray points1, InputArray points2, const Params& params,
                         OutputArray mask, Report& report)
{
    return Usac::create(SIMILARITY, points1, points2, params)->run(mask, &report);
}

Mat estimateSimilarity2D(InputArray points1, InputArray points2, const Params& params,
                         OutputArray mask)
{
    return Usac::create(SIMILARITY, points1, points2, params)->run(mask);
}

Mat estimateTranslation2D(InputArray points1, InputArray points2, const Params& params,
                          OutputArray mask, Report& report)
{
    return Usac::create(TRANSLATION_2D, points1, points2, params)->run(mask, &report);
}

Mat estimateTranslation2D(InputArray points1, InputArray points2, const Params& params,
                          OutputArray mask)
{
    return Usac::create(TRANSLATION_2D, points1, points2, params)->run(mask);
}

Mat estimateRigid3D(InputArray points1, InputArray points2, const Params& params, OutputArray mask,
                    Report& report)
{
    return Usac::create(RIGID_3D, points1, points2, params)->run(mask, &report);
}

Mat estimateRigid3D(InputArray points1, InputArray points2, const Params& params, OutputArray mask)
{
    return Usac::create(RIGID_3D, points1, points2, params)->run(mask);
}

Mat estimateSimilarity3D(InputArray points1, InputArray points2, const Params& params,
                         OutputArray mask, Report& report)
{
    return Usac::create(SIMILARITY_3D, points1, points2, params)->run(mask, &report);
}

Mat estimateSimilarity3D(InputArray points1, InputArray points2, const Params& params,
                         OutputArray mask)
{
    return Usac::create(SIMILARITY_3D, points1, points2, params)->run(mask);
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                      InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2,
                      const Params& params, OutputArray mask, Report& report)
{
    return estimateModel(ESSENTIAL, points1, points2, params, mask, report, cameraMatrix1,
                         cameraMatrix2, distCoeffs1, distCoeffs2);
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                      const Params& params, OutputArray mask)
{
    return calling(ONE_CAMERA, [&] {
        return Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix)->run(mask);
    });
}

Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                      const Params& params, OutputArray mask, Report& report)
{
    return calling(ONE_CAMERA, [&] {
        return Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix)->run(mask, &report);
    });
}

Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                         InputArray distCoeffs, const Params& params, OutputArray mask,
                         Report& report)
{
    return calling(POSE, [&] {
        return Usac::create(ABSOLUTE_POSE, objectPoints, imagePoints, params, cameraMatrix,
                            noArray(), distCoeffs)
            ->run(mask, &report);
    });
}

Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                         InputArray distCoeffs, const Params& params, OutputArray mask)
{
    return calling(POSE, [&] {
        return Usac::create(ABSOLUTE_POSE, objectPoints, imagePoints, params, cameraMatrix,
                            noArray(), distCoeffs)
            ->run(mask);
    });
}

}  // namespace usacv20
}  // namespace cv
