// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Raises a cv::Exception if `model` cannot be a model. Called before the points are read, so that
//! the message is about `model` if the caller has passed points in its place.
void checkModel(InputArray model)
{
    if (model.channels() != 1 || model.total() > MAX_MODEL_SIZE)
        CV_Error_(Error::StsBadArg,
                  ("model: a matrix of at most %d numbers is expected, not %d with %d channel(s)",
                   (int)MAX_MODEL_SIZE, (int)model.total(), model.channels()));
}

}  // namespace

Mat fitModel(ProblemType problem, InputArray points1, InputArray points2, const Params& params,
             OutputArray mask, Report& report, InputArray weights, InputArray chosen,
             InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
             InputArray distCoeffs2)
{
    return Usac::create(problem, points1, points2, params, cameraMatrix1, cameraMatrix2,
                        distCoeffs1, distCoeffs2)
        ->fit(weights, chosen, mask, &report);
}

Mat refineModel(ProblemType problem, InputArray model, InputArray points1, InputArray points2,
                const Params& params, OutputArray mask, Report& report, InputArray chosen,
                InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
                InputArray distCoeffs2)
{
    checkModel(model);
    return Usac::create(problem, points1, points2, params, cameraMatrix1, cameraMatrix2,
                        distCoeffs1, distCoeffs2)
        ->refine(model, chosen, mask, &report);
}

Mat modelErrors(ProblemType problem, InputArray model, InputArray points1, InputArray points2,
                const Params& params, InputArray cameraMatrix1, InputArray cameraMatrix2,
                InputArray distCoeffs1, InputArray distCoeffs2)
{
    checkModel(model);
    return Usac::create(problem, points1, points2, params, cameraMatrix1, cameraMatrix2,
                        distCoeffs1, distCoeffs2)
        ->errors(model);
}

}  // namespace usacv20
}  // namespace cv
