// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "factory.hpp"
#include "problem_data.hpp"
#include "ransac.hpp"
#include "solvers/parameterization.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

double milliseconds(int64 since)
{
    return (getTickCount() - since) / getTickFrequency() * 1e3;
}

class UsacImpl : public Usac
{
public:
    UsacImpl(ProblemType problem, InputArray points1, InputArray points2, const Params& params_,
             InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1, InputArray distCoeffs2)
        : created(getTickCount()), params(params_),
          data(problem, points1, points2, params_, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2),
          parts(createComponents(data.points(), params_)), randomRatio(1)
    {
    }

    Components& components() CV_OVERRIDE { return parts; }
    const Correspondences& points() const CV_OVERRIDE { return data.points(); }

    Mat run(OutputArray mask, Report* report) CV_OVERRIDE
    {
        CV_Assert(parts.residual && parts.score && parts.sampler && parts.minimalSolver);
        const Context context(data.points(), parts, params);
        State state;
        if (data.points().size >= parts.minimalSolver->sampleSize())
            search(context, state);
        else
            state.report.stop = STOP_TOO_FEW_POINTS;
        return finish(context, state, mask, report);
    }

private:
    void search(const Context& context, State& state)
    {
        state.report.setupMs = milliseconds(created);
        Ransac ransac(context, state);
        ransac.run();
        state.report.iterations = state.iteration;
        randomRatio = ransac.randomInlierRatio();
    }

    //! Could the inliers agree by chance?
    void judge(int points, const std::vector<uchar>& inliers, Report& learned) const
    {
        learned.independentInliers = data.independentInliers(inliers);
        const int repeated = learned.inliers - learned.independentInliers;
        learned.chance = chanceOf(learned.independentInliers, std::max(points - repeated, 1), parts.minimalSolver->sampleSize(),
                                  randomRatio);
    }

    //! Polishes the best model and gives it back in the caller's coordinates, with the mask that belongs to it.
    Mat finish(const Context& context, State& state, OutputArray mask, Report* report)
    {
        const int64 start = getTickCount();
        Report& learned = state.report;
        std::vector<uchar> inliers(context.points.inputSize, 0);
        Mat result;
        if (state.bestQuality.inliers >= parts.minimalSolver->sampleSize())
        {
            data.setThreshold(parts.score->threshold(context, state.best));
            if (parts.polisher)
                parts.polisher->polish(context, state.best);
            if (data.points().problem != HOMOGRAPHY)  // what a minimal solver found may miss the constraints
                state.best = Parameterization(data.points().problem, state.best).model();
            if (report)
                learned.cost = context.rate(state.best).cost / context.points.size;
            Matx33d model;
            if (data.toInput(state.best, model))
            {
                learned.inliers = data.mask(*parts.residual, model, inliers);
                if (learned.inliers > 0)
                    result = Mat(model, true);
            }
        }
        if (result.empty() && learned.stop != STOP_TOO_FEW_POINTS)
            learned.stop = STOP_NO_MODEL;
        if (mask.needed())
            Mat(inliers, false).reshape(1, context.points.inputSize).copyTo(mask);
        learned.threshold = data.threshold();
        if (report && !result.empty())
            judge(context.points.size, inliers, learned);
        learned.polishMs = milliseconds(start);
        if (report)
            *report = learned;
        return result;
    }

    const int64 created;
    const Params params;
    ProblemData data;
    Components parts;
    double randomRatio;  //!< of the points, agree with a wrong model
};

} // namespace

Ptr<Usac> Usac::create(ProblemType problem, InputArray points1, InputArray points2, const Params& params,
                       InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
                       InputArray distCoeffs2)
{
    return makePtr<UsacImpl>(problem, points1, points2, params, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2);
}

} // namespace usacv20
} // namespace cv
