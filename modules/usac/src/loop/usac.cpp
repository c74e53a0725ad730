// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/automatic_threshold.hpp"
#include "components/check_components.hpp"
#include "loop/factory.hpp"
#include "loop/given_models.hpp"
#include "problems/registry.hpp"
#include "problems/noise_of_matches.hpp"
#include "input/problem_data.hpp"
#include "loop/ransac.hpp"
#include "loop/reach.hpp"
#include "control/watch.hpp"
#include "significance/model_covariance.hpp"
#include "significance/significance.hpp"
#include "numeric/chi_square.hpp"
#include "components/repetitions.hpp"
#include "termination/termination.hpp"

namespace cv {
namespace usacv20 {

namespace {

double milliseconds(int64 since) { return (getTickCount() - since) / getTickFrequency() * 1e3; }

//! Used if Params::significance is 0. A model is rejected if its Report::chance exceeds LIMIT, but
//! only if there are so many points that the chance of a model with the inlier ratio DECISIVE would
//! not exceed LIMIT. With half or double these values, no correct model is rejected and no run
//! differs; see section "Significance" of doc/design.md.
constexpr double LIMIT = 0.01, DECISIVE = 0.25;
/* Polishing is undone unless at least this fraction of the gain of the model remains. The gain is
the number of points, which is the cost without any model, minus the cost. If the threshold is no
larger than the noise, KEPT = 0.9 makes the error of H 3.1 times that of a least-squares fit,
because polishing is undone; KEPT = 0.5 makes it 1.2 times that error. On the data of the benchmark,
0.25 changes nothing; 1 raises errors by 2 to 6 %. */
constexpr double KEPT = 0.5;
//! What lastWarning() returns.
thread_local String warningOfLastRun;

//! Report::chance is not computed exactly if it is below this value and below a hundredth of its
//! limit. Halving or doubling this value changes no run.
constexpr double CLEAR = 1e-6;

class UsacImpl : public Usac
{
public:
    UsacImpl(const Ptr<Problem>& problem_, InputArray points1, InputArray points2,
             const Params& params_)
        : readTicks(0), begun(0), params(params_), problem(problem_), keepsImage(true),
          sampled(false)
    {
        // before any other method of the problem is used
        const String wrong = findWrongNumber(*problem, params.residual);
        if (!wrong.empty())
            CV_Error_(Error::StsBadArg, ("problem %s: %s", problem->name().c_str(), wrong.c_str()));
        const Ptr<Residual> residual = problem->createResidual(params.residual);
        keepsImage = !problem->createImageResidual(residual).empty();
        setPoints(points1, points2);
        parts = made = createComponents(*problem, params, data.points());
        seeImage(residual);
        imageParts = parts;  // so that the lists in imageParts are allocated before the first run
        fitted = rated = made.residual;
        if (params.thresholdType == THRESHOLD_ESTIMATED)
            automatic = makePtr<AutomaticThreshold>(*problem, params, data.points());
    }

    Components& components() CV_OVERRIDE { return parts; }
    const Correspondences& points() const CV_OVERRIDE { return data.points(); }

    void setPoints(InputArray points1, InputArray points2) CV_OVERRIDE
    {
        const int64 start = getTickCount();
        data.read(*problem, points1, points2, params, arena, keepsImage);
        readTicks = getTickCount() - start;
    }

    Mat run(OutputArray mask, Report* report) CV_OVERRIDE
    {
        const int64 reading = spent();
        begun = getTickCount() - reading;
        Watch watch(params.maxTime, reading);
        prepare();
        const Context context(data.searchPoints(), parts, params, arena,
                              watch.isActive() ? &watch : 0);
        State state;
        sampled = false;
        watch.begin(state, context.points.size);
        const bool enough = data.points().size >= parts.minimalSolver->sampleSize();
        Model guess;
        const bool guessed = automatic && enough && automatic->guess(context, data, guess);
        start(context);
        if (parts.score != made.score)
            checkScore(*parts.score, context.points.size);
        if (enough)
            search(context, state, guessed ? &guess : 0);
        else
            state.report.stop = STOP_TOO_FEW_POINTS;
        const Context all(data.points(), parts, params, arena, context.watch);
        if (data.points().size > data.searchPoints().size)
            start(all);
        return finish(all, state, mask, report);
    }

    Mat fit(InputArray weights, InputArray chosen, OutputArray mask, Report* report) CV_OVERRIDE
    {
        Watch watch(params.maxTime, spent());
        prepare();
        data.useRepetitions(true);
        const Context context(data.points(), parts, params, arena, watch.isActive() ? &watch : 0);
        start(context);
        return given(context).fit(weights, chosen, mask, report);
    }

    Mat refine(InputArray model, InputArray chosen, OutputArray mask, Report* report) CV_OVERRIDE
    {
        Watch watch(params.maxTime, spent());
        prepare();
        data.useRepetitions(true);
        const Context context(data.points(), parts, params, arena, watch.isActive() ? &watch : 0);
        start(context);
        GivenModels models = given(context);
        if (!chosen.empty())
            return models.refine(model, chosen, mask, report);
        State state;
        models.read(model, &state.best);
        state.report.stop = STOP_TOO_FEW_POINTS;
        if (context.points.size < parts.minimalSolver->sampleSize())
            return models.give(state, mask, report);
        state.report.stop = STOP_NO_SEARCH;
        if (automatic)
            automatic->look(context, state.best);
        settleThreshold(context, state);
        polishAsSeen(context, state.best);
        if (report && params.covariance)
            tellCertainty(context, state.best, state.report);
        return models.give(state, mask, report);
    }

    Mat errors(InputArray model) CV_OVERRIDE
    {
        prepare();
        const Context context(data.points(), parts, params, arena);
        parts.residual->start(context);
        if (imageResidual)
            imageResidual->start(context);
        return given(context).errors(model);
    }

private:
    //! Ticks that reading the points has taken; 0 if an earlier call has counted them.
    int64 spent()
    {
        const int64 ticks = readTicks;
        readTicks = 0;
        return ticks;
    }

    //! Undoes what a previous run has changed, checks the components, and adapts the solver and the
    //! image residual to a replaced residual.
    void prepare()
    {
        data.restoreThreshold();
        data.useRepetitions(false);
        checkComponents(parts);
        checkNoise(*parts.residual, data.points());
        if (parts.residual != fitted && parts.nonMinimalSolver == made.nonMinimalSolver)
        {
            parts.nonMinimalSolver = made.nonMinimalSolver = problem->createNonMinimalSolver(
                parts.residual);
            fitted = parts.residual;
        }
        if (parts.residual != rated)
        {
            rated = parts.residual;
            // made.residual can be a residual with sigmas, which has no counterpart for the image
            seeImage(rated == made.residual ? problem->createResidual(params.residual) : rated);
        }
        arena.clear();
    }

    void start(const Context& context)
    {
        parts.start(context);
        if (imageResidual)
            imageResidual->start(context);
    }

    //! @param guess initial model of the search; null: there is none
    void search(const Context& context, State& state, const Model* guess)
    {
        state.report.setupMs = milliseconds(begun);
        Ransac ransac(context, state, parts.sampler != made.sampler);
        if (!params.initialModel.empty())
            begin(context, ransac);
        if (guess)
            ransac.begin(*guess, automatic->bestSample(), automatic->uniformSamples());
        if (params.widestReach > params.reach && !automatic)
            searchWithReach(context, state, data, ransac);
        else
            ransac.run();
        if (automatic)
            automatic->adapt(context, data, state, ransac);
        state.report.iterations = state.iteration;
        sampled = ransac.bestSample() != 0;
        if (sampled)
            sample = *ransac.bestSample();
    }

    void begin(const Context& context, Ransac& ransac)
    {
        Model model;
        if (!problem->fromOutput(params.initialModel, context.points, model))
            CV_Error_(Error::StsBadArg,
                      ("initialModel: the %d numbers are not a model of the problem %s",
                       (int)params.initialModel.size(), problem->name().c_str()));
        if (!params.initialCovariance.empty())
            ModelCovariance::checkPrior(priorCovariance());
        ransac.beginNear(model);
    }

    //! Tests whether a model with as many inliers could have been found in random matches, and sets
    //! Report::chance. @return false if the model must be rejected
    bool significant(const Context& context, const Model& model, Report& learned)
    {
        const bool unset = params.significance == 0;
        const double limit = unset ? LIMIT : params.significance;
        const double samples = automatic ? automatic->samples() : 0,
                     models = automatic ? automatic->models() : 0;
        const SearchEffort effort = {
            parts.minimalSolver->sampleSize(), samples + learned.iterations,
            models + learned.models - learned.rejectedModels,
            parts.score->countsInliers() && parts.localOptimizer, !parts.score->usesThreshold()};
        const double grown = std::max(data.reach() / params.reach,
                                      1.);  // factor by which the reach has grown with the noise
        Significance test(*parts.residual, model, data.points(), data.maskThreshold() * grown,
                          effort, arena, &context);
        learned.chance = test.chance(learned.inliers, std::min(CLEAR, limit / 100));
        return learned.chance <= limit || (unset && !test.decisive(DECISIVE, limit));
    }

    /** Polishes the best model. Polishing minimizes a loss other than the score, and can end at a
    compromise between two models: if the score is clearly worse afterward, the model of the search
    is kept. @return score of the final model */
    Quality polish(const Context& context, Model& best)
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
        const Quality quality = context.rate(best);
        const double size = context.points.size;
        if (size - quality.cost >= KEPT * (size - before.cost))  // false if the cost is NaN
            return quality;
        best = found;
        return before;
    }

    //! If the problem has a residual for the original image points, creates this residual and its
    //! solver. Polishing and the mask use them instead of those of the search.
    void seeImage(const Ptr<Residual>& residual)
    {
        imageResidual = keepsImage ? imageResidualWithNoise(*problem, residual, data.points())
                                   : Ptr<Residual>();
        imageFit = imageResidual ? problem->createNonMinimalSolver(imageResidual)
                                 : Ptr<NonMinimalSolver>();
    }

    //! Calls polish(), with the original image points if the problem has a residual for them and
    //! the caller has not replaced the solver, which might not support them.
    Quality polishAsSeen(const Context& context, Model& best)
    {
        if (!fitAsSeen())
            return polish(context, best);
        const Correspondences seen = data.imagePoints();
        imageParts = parts;
        imageParts.residual = imageResidual;
        imageParts.nonMinimalSolver = imageFit;
        imageFit->start(context);
        return polish(Context(seen, imageParts, params, arena, context.watch), best);
    }

    //! Sets the threshold of the mask and of the steps after the search.
    void settleThreshold(const Context& context, State& state)
    {
        if (automatic)
            state.report.sigma = automatic->settle(data);
        else
            data.setThreshold(parts.score->threshold(context, state.best));
    }

    //! The solver for the original image points; empty if polishAsSeen() does not use them.
    Ptr<NonMinimalSolver> fitAsSeen() const
    {
        return parts.nonMinimalSolver == made.nonMinimalSolver ? imageFit : Ptr<NonMinimalSolver>();
    }

    GivenModels given(const Context& context)
    {
        return GivenModels(context, data, imageResidual, fitAsSeen());
    }

    //! Params::initialCovariance as a matrix.
    Mat priorCovariance() const
    {
        const int d = problem->dimension(), count = (int)params.initialCovariance.size();
        if (count != d * d)
            CV_Error_(Error::StsBadArg, ("initialCovariance: %d x %d numbers are expected for the "
                                         "problem %s, not %d",
                                         d, d, problem->name().c_str(), count));
        return Mat(params.initialCovariance, true).reshape(1, d);
    }

    //! If Params::covariance is 1, computes Report::covariance of a polished model and, unless the
    //! threshold was estimated, Report::sigma. To be called after polishAsSeen(), which sets
    //! imageParts.
    //! @param prior the initial model, or null. If there is a prior, Report::priorChance is set; if
    //! the prior agrees with `model`, the weighted mean of both replaces `model`
    //! @return score of the model
    Quality tellCertainty(const Context& context, Model& model, Report& learned,
                          const Model* prior = 0) const
    {
        const bool image = !fitAsSeen().empty();
        const Correspondences points = image ? data.imagePoints() : context.points;
        const Context polishing(points, image ? imageParts : parts, params, context.arena,
                                context.watch);
        ModelCovariance covariance(polishing);
        covariance.estimate(model);
        if (prior)
        {
            learned.priorChance = covariance.weigh(*prior, priorCovariance());
            if (learned.priorChance >= ModelCovariance::LEAST_CHANCE)
                model = problem->closest(covariance.model());
        }
        if (params.covariance)
            learned.covariance = covariance.ofCaller();
        if (!automatic && params.covariance)
            learned.sigma = covariance.sigma() * (data.threshold() / data.maskThreshold());
        return polishing.rate(model);
    }

    //! Writes the sample as row indices of the caller's points. Allocates only if the capacity of
    //! `rows` is too small.
    void writeSample(const Context& context, std::vector<int>& rows) const
    {
        int row[MAX_SAMPLE_SIZE];
        const int size = parts.minimalSolver->sampleSize();
        for (int i = 0; i < size; ++i)
            row[i] = context.points.inputIndex[sample[i]];
        rows.assign(row, row + size);
    }

    //! Updates the stop reason if the run was stopped meanwhile, for example during polishing.
    static void tellStop(const Context& context, Report& learned)
    {
        if (context.watch && context.watch->stopped() && learned.stop != STOP_CANCELLED)
            learned.stop = context.watch->stopReason();
    }

    //! Polishes the best model and returns it in the caller's coordinates, with its mask, or an
    //! empty matrix if there is no model. `inliers` must be all 0 before.
    Mat polishedModel(const Context& context, State& state, uchar* inliers)
    {
        Report& learned = state.report;
        if (state.bestQuality.inliers < parts.minimalSolver->sampleSize())
            return Mat();
        settleThreshold(context, state);
        learned.cost = polishAsSeen(context, state.best).cost / context.points.size;
        if (!params.initialCovariance.empty())
        {
            Model prior;
            problem->fromOutput(params.initialModel, context.points, prior);
            learned.cost = tellCertainty(context, state.best, learned, &prior).cost /
                           context.points.size;
        }
        Model model;
        if (!problem->toInput(state.best, context.points, model))
            return Mat();
        const Mat result = problem->toOutput(model);
        const Ptr<Residual>& residual = imageResidual ? imageResidual : parts.residual;
        learned.inliers = data.mask(*residual, modelOfMask(*problem, result, model),
                                    !imageResidual.empty(), inliers);
        return learned.inliers == 0 && data.reach() <= params.reach ? Mat() : result;
    }

    //! Polishes the best model and returns it in the caller's coordinates, with its mask. Returns
    //! an empty matrix if there is no significant model.
    Mat finish(const Context& context, State& state, OutputArray mask, Report* report)
    {
        const int64 start = getTickCount();
        Report& learned = state.report;
        const int rows = context.points.inputSize;
        if (context.watch)
            context.watch->finish();
        uchar* const inliers = arena.take<uchar>(rows);
        std::fill(inliers, inliers + rows, (uchar)0);
        Mat result = polishedModel(context, state, inliers);
        learned.degenerate = state.degenerate;
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
        if (result.empty())
        {
            learned.covariance.release();
            learned.sigma = learned.cost = learned.priorChance = 0;
        }
        else if (report && params.covariance && params.initialCovariance.empty())
            tellCertainty(context, state.best, learned);
        if (mask.needed())
            Mat(rows, 1, CV_8U, inliers).copyTo(mask);
        const bool timely = learned.inliers <= ENOUGH ||
                            !context.stopBefore(learned.inliers * REPETITION_WORK);
        tellStop(context, learned);
        data.tell(inliers, timely && report && !result.empty(), arena, learned);
        warningOfLastRun = learned.warning;
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
    int64 readTicks;  //!< duration of reading the points; 0: a call has counted it
    int64 begun;      //!< beginning of the last run, in ticks, earlier by the duration of reading
    const Params params;
    const Ptr<Problem> problem;
    ProblemData data;
    Components parts;
    Ptr<AutomaticThreshold> automatic;  //!< null: the threshold is not estimated
    Components made;                    //!< the default components; the solver adapts to a replaced
                                        //!< residual
    Ptr<Residual> fitted;               //!< the residual that made.nonMinimalSolver minimizes
    Ptr<Residual> rated;                //!< the residual that imageResidual was created for
    Ptr<Residual> imageResidual;        //!< counterpart of `rated` for the original image points;
                                        //!< can be empty
    Ptr<NonMinimalSolver> imageFit;     //!< the least-squares solver for imageResidual
    Components imageParts;              //!< components for polishing with original image points
    bool keepsImage;                    //!< the original image points are stored, too
    Sample sample;                      //!< the sample that led to the best model of the run
    bool sampled;                       //!< false if the best model did not come from a sample
};

}  // namespace

String lastWarning() { return warningOfLastRun; }

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
