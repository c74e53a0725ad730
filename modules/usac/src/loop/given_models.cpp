// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/repetitions.hpp"
#include "components/sample_group.hpp"
#include "components/streams.hpp"
#include "control/watch.hpp"
#include "loop/given_models.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! START_SAMPLES: number of samples whose models are compared by their errors. START_MODELS: a
//! least-squares fit starts from each of the best of these models, at most this many.
constexpr int START_SAMPLES = 64, START_MODELS = 4;
//! PART: maximum number of points with which initial models are compared and fitted. MOST_STEPS:
//! maximum number of steps of a fit; fits converge earlier.
constexpr int PART = 500, MOST_STEPS = 100;

//! Converts a list with one number for each of `size` points to CV_64F. An empty list gives an
//! empty matrix.
Mat readNumbers(InputArray given, int size, const char* name)
{
    const Mat list = given.getMat();
    if (list.empty())
        return Mat();
    if ((int)(list.total() * list.channels()) != size)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("%s: one number for each of the %d points is expected, not %d", name, size,
                   (int)(list.total() * list.channels())));
    Mat numbers;
    (list.isContinuous() ? list : list.clone()).reshape(1, size).convertTo(numbers, CV_64F);
    return numbers;
}

//! The START_MODELS models of the lowest losses, in ascending order of the loss.
struct Starts
{
    Starts() { std::fill(losses, losses + START_MODELS, DBL_MAX); }

    void offer(const Model& model, double loss)
    {
        int place = START_MODELS;
        for (; place > 0 && loss < losses[place - 1]; --place)
            if (place < START_MODELS)
            {
                losses[place] = losses[place - 1];
                models[place] = models[place - 1];
            }
        if (place == START_MODELS)
            return;
        losses[place] = loss;
        models[place] = model;
    }

    Model models[START_MODELS];
    double losses[START_MODELS];  //!< DBL_MAX: there is no model
};

}  // namespace

GivenModels::GivenModels(const Context& context_, ProblemData& data_,
                         const Ptr<Residual>& imageResidual, const Ptr<NonMinimalSolver>& imageFit)
    : context(context_), data(data_),
      residual(imageResidual ? imageResidual : context_.components.residual),
      asSeen(!imageResidual.empty()),
      fitted(imageFit ? imageResidual : context_.components.residual),
      points(imageFit ? data_.imagePoints() : context_.points), solver(imageFit),
      problem(*context_.points.problem), start(getTickCount()), indices(0), weights(0), count(0)
{
    if (imageFit)
        imageFit->start(context);
}

Mat GivenModels::fit(InputArray weightOfEach, InputArray chosen, OutputArray mask, Report* report)
{
    choose(weightOfEach, chosen);
    State state;
    Model best;
    if (count < context.components.minimalSolver->sampleSize())
        state.report.stop = STOP_TOO_FEW_POINTS;
    else
        state.report.stop = begin(best) && leastSquares(count, best) ? STOP_NO_SEARCH
                                                                     : STOP_NO_MODEL;
    state.best = best;
    setThreshold(state);
    return give(state, mask, report);
}

Mat GivenModels::refine(InputArray model, InputArray chosen, OutputArray mask, Report* report)
{
    choose(noArray(), chosen);
    State state;
    read(model, &state.best);
    if (count < context.components.minimalSolver->sampleSize())
        state.report.stop = STOP_TOO_FEW_POINTS;
    else
        state.report.stop = leastSquares(count, state.best) ? STOP_NO_SEARCH : STOP_NO_MODEL;
    setThreshold(state);
    return give(state, mask, report);
}

Mat GivenModels::errors(InputArray model) const
{
    Mat result(points.inputSize, 1, CV_64F);
    data.errors(*residual, read(model, 0), asSeen, result.ptr<double>());
    return result;
}

Model GivenModels::read(InputArray given, Model* forSearch) const
{
    const Mat matrix = given.getMat();
    Mat numbers;
    if (matrix.dims <= 2 && matrix.channels() == 1)
        matrix.convertTo(numbers, CV_64F);
    Model searched, model;
    const bool usable = !numbers.empty() && checkRange(numbers) &&
                        problem.fromOutput(
                            std::vector<double>(numbers.begin<double>(), numbers.end<double>()),
                            context.points, searched);
    if (!usable || !problem.toInput(searched, context.points, model) ||
        problem.toOutput(model).size() != numbers.size())
        CV_Error_(Error::StsBadArg, ("model: the %d x %d numbers are not a model of the problem %s",
                                     matrix.rows, matrix.cols, problem.name().c_str()));
    if (forSearch)
        *forSearch = searched;
    return modelOfMask(problem, numbers, model);
}

void GivenModels::choose(InputArray weightOfEach, InputArray chosen)
{
    const int rows = points.inputSize, size = points.size;
    const Mat given = readNumbers(weightOfEach, rows, "weights"),
              part = readNumbers(chosen, rows, "chosen");
    for (int i = 0; i < given.rows; ++i)
        if (!(given.at<double>(i) >= 0 && given.at<double>(i) <= DBL_MAX))
            CV_Error_(Error::StsOutOfRange,
                      ("weights: finite numbers of at least 0 are expected, not %g",
                       given.at<double>(i)));
    indices = context.arena.take<int>(size);
    weights = given.empty() ? 0 : context.arena.take<double>(size);
    for (int i = 0; i < size; ++i)
    {
        const int row = points.inputIndex[i];
        const double weight = given.empty() ? 1 : given.at<double>(row);
        if (!(weight > 0) || (!part.empty() && part.at<double>(row) == 0))
            continue;
        indices[count] = i;
        if (weights)
            weights[count] = weight;
        ++count;
    }
}

double GivenModels::lossOf(PointSubset& part, const Model& model) const
{
    const double* const errors = part.squaredErrors(*fitted, model);
    double sum = 0;
    for (int k = 0; k < part.size(); ++k)
        sum += weights ? weights[k] * errors[k] : errors[k];
    return sum <= DBL_MAX ? sum : DBL_MAX;  // NaN gives DBL_MAX, too
}

bool GivenModels::leastSquares(int size, Model& model) const
{
    const int m = context.components.minimalSolver->sampleSize();
    const NonMinimalSolver& fitter = solver ? *solver : context.nonMinimalSolver();
    return fitter.fit(points, indices, size, weights, model, MOST_STEPS) ||
           (size == m && solveExactly(model));
}

bool GivenModels::solveExactly(Model& model) const
{
    const MinimalSolver& minimal = *context.components.minimalSolver;
    Arena::Scope scope(context.arena);
    PointSubset part(points, minimal.sampleSize(), scope);
    for (int k = 0; k < minimal.sampleSize(); ++k)
        part.add(indices[k]);
    Model models[MAX_MODELS];
    double least = DBL_MAX;
    for (int k = minimal.solve(context.points, indices, models) - 1; k >= 0; --k)
    {
        const double loss = lossOf(part, models[k]);
        if (!(loss < least))
            continue;
        least = loss;
        model = models[k];
    }
    return least < DBL_MAX;
}

bool GivenModels::begin(Model& model) const
{
    const MinimalSolver& minimal = *context.components.minimalSolver;
    const int m = minimal.sampleSize(), size = std::min(count, PART);
    Arena::Scope scope(context.arena);
    PointSubset part(points, size, scope);
    for (int k = 0; k < size; ++k)
        part.add(indices[k]);
    Starts starts;
    const int samples = count > m ? START_SAMPLES : 1;
    SampleGroup group;
    for (int i = 0; i < samples; i += SampleGroup::SIZE)
    {
        const int number = std::min<int>(samples - i, SampleGroup::SIZE);
        for (int j = 0; j < number; ++j)
        {
            int* const sample = group.samples[j];
            Rng(context.params.seed, streamOf(STREAM_FIT, i + j)).distinct(count, m, sample);
            for (int k = 0; k < m; ++k)
                sample[k] = indices[sample[k]];
        }
        group.solve(minimal, context.points, number);
        for (int j = 0; j < number; ++j)
            for (int k = 0; k < group.found[j]; ++k)
                starts.offer(group.models[j][k], lossOf(part, group.models[j][k]));
    }
    double least = DBL_MAX;
    for (int i = 0; i < START_MODELS && starts.losses[i] < DBL_MAX; ++i)
    {
        if (!leastSquares(size, starts.models[i]))
            continue;
        const double loss = lossOf(part, starts.models[i]);
        if (!(loss < least))
            continue;
        least = loss;
        model = starts.models[i];
    }
    return least < DBL_MAX;
}

void GivenModels::setThreshold(const State& state)
{
    if (state.report.stop == STOP_NO_SEARCH)
        data.setThreshold(
            context.components.score->threshold(context, problem.closest(state.best)));
}

double GivenModels::costOf(const Model& model) const
{
    Components parts = context.components;
    parts.residual = fitted;
    Correspondences now = points;
    now.threshold = context.points.threshold;  // may have changed since `points` was copied
    return Context(now, parts, context.params, context.arena).rate(model).cost /
           std::max(points.size, 1);
}

Mat GivenModels::give(State& state, OutputArray mask, Report* report)
{
    Report& learned = state.report;
    const int rows = points.inputSize;
    uchar* const inliers = context.arena.take<uchar>(rows);
    std::fill(inliers, inliers + rows, (uchar)0);
    Mat result;
    Model model;
    const bool found = learned.stop == STOP_NO_SEARCH;
    if (found)
        state.best = problem.closest(state.best);
    if (found && problem.toInput(state.best, context.points, model))
    {
        result = problem.toOutput(model);
        learned.inliers = data.mask(*residual, modelOfMask(problem, result, model), asSeen,
                                    inliers);
        learned.cost = costOf(state.best);
    }
    else if (found)
        learned.stop = STOP_NO_MODEL;
    if (mask.needed())
        Mat(rows, 1, CV_8U, inliers).copyTo(mask);
    const bool timely = learned.inliers <= ENOUGH ||
                        !context.stopBefore(learned.inliers * REPETITION_WORK);
    data.tell(inliers, timely && report && !result.empty(), context.arena, learned);
    if (context.watch && context.watch->stopped())
        learned.stop = context.watch->stopReason();
    learned.polishMs = (getTickCount() - start) / getTickFrequency() * 1e3;
    if (report)
        *report = learned;
    return result;
}

}  // namespace usacv20
}  // namespace cv
