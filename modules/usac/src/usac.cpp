// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "check_components.hpp"
#include "factory.hpp"
#include "given_models.hpp"
#include "problems/problems.hpp"
#include "problem_data.hpp"
#include "ransac.hpp"
#include "reach.hpp"
#include "watch.hpp"
#include "significance/significance.hpp"
#include "core/chi_square.hpp"
#include "core/repetitions.hpp"
#include "polishing/leverage.hpp"
#include "polishing/restarts.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

double milliseconds(int64 since) { return (getTickCount() - since) / getTickFrequency() * 1e3; }

//! The noise is looked at first when one in so many of Params::maxIterations samples have been
//! drawn. 4 and 1 change errors by 2 % at most.
constexpr int FIRST_LOOK = 2;

//! Params::significance 0: the limit, a probability, and the part of the points that must be able
//! to reach it. Half, double: no right model is refused, none of the runs differs; what they refuse
//! is in doc/design.md.
constexpr double LIMIT = 0.01, DECISIVE = 0.25;
/* Part of what a model gains over no model at all that must be left after polishing. With 0.9
polishing is undone where the threshold is no more than the noise: the error of H is 3.1 times that
of least squares, with 0.5 it is 1.2. On the lists half of it changes nothing, 1 raises errors by 2
to 6 %. */
constexpr double KEPT = 0.5;
//! Chances, probabilities, that are smaller need not be known. Half, double: no run differs.
constexpr double CLEAR = 1e-6;

class UsacImpl : public Usac
{
public:
    UsacImpl(const Ptr<Problem>& problem_, InputArray points1, InputArray points2,
             const Params& params_)
        : readTicks(0), params(params_), problem(problem_), keepsImage(true), sampled(false),
          givenReach(params_.reach)
    {
        checkProblem(*problem, params.residual);  // before its numbers are used
        seeImage(problem->createResidual(params.residual));
        keepsImage = !imageResidual.empty();
        setPoints(points1, points2);
        parts = made = createComponents(*problem, params);
        imageParts = parts;  // so that a run finds its lists as long as they have to be
        fitted = rated = made.residual;
    }

    Components& components() CV_OVERRIDE { return parts; }
    const Correspondences& points() const CV_OVERRIDE { return data.points(); }

    void setPoints(InputArray points1, InputArray points2) CV_OVERRIDE
    {
        created = getTickCount();
        params.reach = givenReach;
        data.read(*problem, points1, points2, params, arena, keepsImage);
        readTicks = getTickCount() - created;
    }

    Mat run(OutputArray mask, Report* report) CV_OVERRIDE
    {
        const int64 begun = getTickCount();
        if (created == 0)  // the same points again
            readTicks = 0;
        created = begun - readTicks;  // what the caller did in between does not count
        Watch watch(params.maxTime, readTicks);
        prepare();
        const Context context(data.points(), parts, params, arena, watch.isActive() ? &watch : 0);
        parts.start(context);
        if (parts.score != made.score)
            checkScore(*parts.score);
        State state;
        sampled = false;
        watch.begin(state, data.points().size);
        if (data.points().size >= parts.minimalSolver->sampleSize())
            search(context, state);
        else
            state.report.stop = STOP_TOO_FEW_POINTS;
        created = 0;
        return finish(context, state, mask, report);
    }

    Mat fit(InputArray weights, InputArray chosen, OutputArray mask, Report* report) CV_OVERRIDE
    {
        prepare();
        const Context context(data.points(), parts, params, arena);
        parts.start(context);
        return GivenModels(context, data, imageResidual, imageFit)
            .fit(weights, chosen, mask, report);
    }

    Mat refine(InputArray model, InputArray chosen, OutputArray mask, Report* report) CV_OVERRIDE
    {
        prepare();
        const Context context(data.points(), parts, params, arena);
        parts.start(context);
        GivenModels given(context, data, imageResidual, imageFit);
        if (!chosen.empty())
            return given.refine(model, chosen, mask, report);
        State state;
        given.read(model, &state.best);
        state.report.stop = STOP_NO_SEARCH;
        polishAsSeen(context, state);
        return given.give(state, mask, report);
    }

    Mat errors(InputArray model) CV_OVERRIDE
    {
        prepare();
        const Context context(data.points(), parts, params, arena);
        return GivenModels(context, data, imageResidual, imageFit).errors(model);
    }

private:
    //! Of a run: as if there had been none before.
    void prepare()
    {
        params.reach = givenReach;
        data.restoreThreshold();
        checkComponents(parts);
        if (parts.residual != fitted && parts.nonMinimalSolver == made.nonMinimalSolver)
        {
            parts.nonMinimalSolver = made.nonMinimalSolver = problem->createNonMinimalSolver(
                parts.residual);
            fitted = parts.residual;
        }
        if (parts.residual != rated)
            seeImage(parts.residual);
        arena.clear();
    }

    void search(const Context& context, State& state)
    {
        state.report.setupMs = milliseconds(created);
        Ransac ransac(context, state, parts.sampler != made.sampler);
        if (!params.initialModel.empty())
            begin(context, ransac);
        if (params.widestReach > params.reach)
            searchWithReach(context, state, ransac);
        else
            ransac.run();
        state.report.iterations = state.iteration;
        sampled = ransac.bestSample() != 0;
        if (sampled)
            std::copy(ransac.bestSample(), ransac.bestSample() + parts.minimalSolver->sampleSize(),
                      sample);
    }

    void begin(const Context& context, Ransac& ransac)
    {
        Model model;
        if (!problem->fromOutput(params.initialModel, context.points, model))
            CV_Error_(Error::StsBadArg,
                      ("initialModel: %d numbers, which are no model of the problem %s",
                       (int)params.initialModel.size(), problem->name().c_str()));
        ransac.begin(model);
    }

    /** The search, with a reach that grows with the noise that the best model shows: when the
    search has ended, or half of its samples have been drawn. (With a reach that is far too small
    models are rated by few points, and no criterion ends the search. Earlier, the right model may
    not yet be found, and a wrong one that shows more noise, between two planes, say, would be taken
    for it.) At last it may also shrink again, as poor models show more noise than there is.
  */
    void searchWithReach(const Context& context, State& state, Ransac& ransac)
    {
        const double least = params.reach;
        for (int pause = params.maxIterations / FIRST_LOOK;; pause = INT_MAX)
        {
            const bool ended = ransac.run(pause);
            const double reach = suitableReach(context, state, least);
            if (context.watch && context.watch->stopped())
                return;
            if (reach > REACH_GROWS * params.reach)
                setReach(reach, ransac);
            else if (ended)
                break;
        }
        for (double reach;
             (reach = suitableReach(context, state, least)) < REACH_SHRINKS * params.reach;)
        {
            setReach(reach, ransac);
            if (!(state.bestQuality.cost <= DBL_MAX))  // a check has refused the model
                ransac.run();
        }
    }

    void setReach(double reach, Ransac& ransac)
    {
        data.scaleReach(reach / params.reach);
        params.reach = reach;
        ransac.thresholdChanged();
    }

    //! Could random matches have given this model? @return false if it is to be refused
    bool significant(const Context& context, const Model& model, Report& learned)
    {
        const bool automatic = params.significance == 0;
        const double limit = automatic ? LIMIT : params.significance;
        const SearchEffort effort = {parts.minimalSolver->sampleSize(), (double)learned.iterations,
                                     (double)learned.models - learned.rejectedModels,
                                     params.quality == QUALITY_INLIERS && parts.localOptimizer,
                                     params.quality == QUALITY_LMEDS};
        const double grown = std::max(params.reach / givenReach,
                                      1.);  // as far as the threshold is below the noise
        Significance test(*parts.residual, model, data.points(), data.maskThreshold() * grown,
                          effort, arena, &context);
        learned.chance = test.chance(learned.inliers, std::min(CLEAR, limit / 100));
        return learned.chance <= limit || (automatic && !test.decisive(DECISIVE, limit));
    }

    /** Polishing minimizes another loss than the score, and may end between two models: if the
    score is clearly worse after it, the model stays as the search found it. Few points are polished
    from other starts, too, and a model that wrong matches have bent is freed of them. @param search
    context of the search @param context that of the polishing
    @return quality of the model */
    Quality polish(const Context& search, const Context& context, State& state, Model& best)
    {
        const Model found = problem->closest(best);
        const Quality before = context.rate(found);
        if (!parts.polisher)
        {
            best = found;
            return before;
        }
        parts.polisher->polish(context, best);
        best = problem->closest(best);
        Quality quality = context.rate(best);
        const double size = context.points.size;
        if (!(size - quality.cost >= KEPT * (size - before.cost)))  // or NaN
        {
            best = found;
            quality = before;
        }
        Restarts(search, context, state).improve(best, quality);
        Leverage(search, context,
                 context.points.threshold * data.maskThreshold() / search.points.threshold)
            .improve(best, quality);
        return quality;
    }

    //! What polishing and mask take in the place of a residual of the search, if there is something
    //! better.
    void seeImage(const Ptr<Residual>& residual)
    {
        rated = residual;
        imageResidual = keepsImage ? problem->createImageResidual(residual) : Ptr<Residual>();
        imageFit = imageResidual ? problem->createNonMinimalSolver(imageResidual)
                                 : Ptr<NonMinimalSolver>();
    }

    //! The same with the points as they were seen, if the solver is not one of the caller's, which
    //! may not know them.
    Quality polishAsSeen(const Context& context, State& state)
    {
        if (!imageFit || parts.nonMinimalSolver != made.nonMinimalSolver)
            return polish(context, context, state, state.best);
        const Correspondences seen = data.imagePoints();
        imageParts = parts;
        imageParts.residual = imageResidual;
        imageParts.nonMinimalSolver = imageFit;
        imageFit->start(context);
        return polish(context, Context(seen, imageParts, params, arena, context.watch), state,
                      state.best);
    }

    //! In the order of the caller's points. Memory is asked for only where `rows` has not had as
    //! many before.
    void writeSample(const Context& context, std::vector<int>& rows) const
    {
        int row[MAX_SAMPLE_SIZE];
        const int size = parts.minimalSolver->sampleSize();
        for (int i = 0; i < size; ++i)
            row[i] = context.points.inputIndex[sample[i]];
        rows.assign(row, row + size);
    }

    //! The time was over while polishing, say.
    static void tellStop(const Context& context, Report& learned)
    {
        if (context.watch && context.watch->stopped() && learned.stop != STOP_CANCELLED)
            learned.stop = context.watch->stopReason();
    }

    //! Polishes the best model and gives it back in the caller's coordinates, with the mask that
    //! belongs to it.
    Mat finish(const Context& context, State& state, OutputArray mask, Report* report)
    {
        const int64 start = getTickCount();
        Report& learned = state.report;
        const int rows = context.points.inputSize;
        if (context.watch)
            context.watch->finish();
        uchar* const inliers = arena.take<uchar>(rows);
        std::fill(inliers, inliers + rows, (uchar)0);
        Mat result;
        if (parts.polisher && !(state.bestQuality.cost <= DBL_MAX) &&
            context.points.size > parts.minimalSolver->sampleSize())
            sampled = !Restarts(context, context, state).begin(state.best, state.bestQuality) &&
                      sampled;
        if (state.bestQuality.inliers >= parts.minimalSolver->sampleSize())
        {
            data.setThreshold(parts.score->threshold(context, state.best));
            learned.cost = polishAsSeen(context, state).cost / context.points.size;
            Model model;
            if (problem->toInput(state.best, context.points, model))
            {
                result = problem->toOutput(model);
                const Ptr<Residual>& residual = imageResidual ? imageResidual : parts.residual;
                learned.inliers = data.mask(*residual, modelOfMask(*problem, result, model),
                                            !imageResidual.empty(), inliers, arena);
                if (learned.inliers == 0 && params.reach <= givenReach)
                    result.release();
            }
        }
        tellStop(context, learned);
        if (result.empty() && learned.stop != STOP_TOO_FEW_POINTS && learned.stop < STOP_TIME)
            learned.stop = STOP_NO_MODEL;
        if (!result.empty() && (report || params.significance < 1) &&
            !significant(context, state.best, learned))
        {
            tellStop(context, learned);
            learned.stop = learned.stop < STOP_TIME ? (int)STOP_NOT_SIGNIFICANT : learned.stop;
            learned.inliers = 0;
            std::fill(inliers, inliers + rows, (uchar)0);
            result.release();
        }
        if (mask.needed())
            Mat(rows, 1, CV_8U, inliers).copyTo(mask);
        const bool timely = learned.inliers <= ENOUGH ||
                            !context.stopBefore(learned.inliers * REPETITION_WORK);
        tellStop(context, learned);
        data.tell(inliers, timely && report && !result.empty(), arena, learned);
        learned.polishMs = milliseconds(start);
        if (report)
        {
            *report = learned;
            if (sampled && !result.empty())
                writeSample(context, report->sample);
        }
        return result;
    }

    Arena arena;      //!< memory of the runs
    int64 created;    //!< when the points came; 0: they have been used
    int64 readTicks;  //!< that reading them took
    Params params;    //!< `reach` is the present one
    const Ptr<Problem> problem;
    ProblemData data;
    Components parts;
    Components made;                 //!< for `params`, some of which the caller may have replaced
    Ptr<Residual> fitted;            //!< that made.nonMinimalSolver fits
    Ptr<Residual> rated;             //!< that of the last run
    Ptr<Residual> imageResidual;     //!< Problem::createImageResidual of that; empty: there is none
    Ptr<NonMinimalSolver> imageFit;  //!< its least squares
    Components imageParts;           //!< while polishing
    bool keepsImage;                 //!< the points are there as they were seen, too
    int sample[MAX_SAMPLE_SIZE];     //!< that led to the best model of the run
    bool sampled;                    //!< is there one?
    const double givenReach;
};

}  // namespace

Ptr<Usac> Usac::create(ProblemType problem, InputArray points1, InputArray points2,
                       const Params& params, InputArray cameraMatrix1, InputArray cameraMatrix2,
                       InputArray distCoeffs1, InputArray distCoeffs2)
{
    return create(createProblem(problem, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2),
                  points1, points2, params);
}

Ptr<Usac> Usac::create(const Ptr<Problem>& problem, InputArray points1, InputArray points2,
                       const Params& params)
{
    if (!problem)
        CV_Error(Error::StsNullPtr, "problem: it is empty");
    return makePtr<UsacImpl>(problem, points1, points2, params);
}

}  // namespace usacv20
}  // namespace cv
