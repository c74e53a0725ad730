// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "search_bound.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include "counting_solver.hpp"
#include "counting_verifier.hpp"
#include "stopwatch.hpp"

namespace benchmark {

using namespace cv::usacv20;
using opencv_test::Scene;

namespace {

//! Number of times that each scene is timed; the minimum time is used.
const int ROUNDS = 15;

//! Milliseconds in which `solver` solves all samples that were recorded in `samples`, in batches of
//! the same size as in a run. Wall time, as in Report::searchMs. @param found output: number of
//! models
double solverMsOf(const Usac& usac, const MinimalSolver& solver, const CountingSolver& samples,
                  int& found)
{
    const int together = solver.together();
    std::vector<Model> models(together * MAX_MODELS);
    std::vector<const int*> drawn(together);
    std::vector<Model*> places(together);
    std::vector<int> counts(together);
    const Stopwatch watch;
    found = 0;
    for (int i = 0; i < samples.solved(); i += together)
    {
        const int count = std::min(together, samples.solved() - i);
        for (int k = 0; k < count; ++k)
        {
            drawn[k] = samples.sample(i + k);
            places[k] = &models[k * MAX_MODELS];
        }
        solver.solveMany(usac.points(), drawn.data(), count, places.data(), counts.data());
        for (int k = 0; k < count; ++k)
            found += counts[k];
    }
    return watch.wallMs();
}

//! Mean wall time in milliseconds in which the error of one point under one model is computed and
//! scored.
double kernelMsOf(const Context& context, const std::vector<Model>& models)
{
    const Stopwatch watch;
    for (size_t k = 0; k < models.size(); ++k)
        context.rate(models[k]);
    return models.empty() ? 0 : watch.wallMs() / ((double)models.size() * context.points.size);
}

std::string perUnit(double ms, int64 count, double unit)
{
    return count ? cv::format("%.3g", ms * unit / count) : std::string("-");
}

}  // namespace

SearchBound::SearchBound(const std::string& method_, ProblemType problem_, double part_,
                         const ScaleOptions& options_)
    : method(method_), problem(problem_), part(part_), options(options_), samples(0), solved(0),
      models(0), points(0), searchMs(0), solverMs(0), kernelMs(0), allSolverMs(0)
{}

void SearchBound::run(const Params& params)
{
    Params own = params;
    own.threads = 1;
    for (int repeat = 0; repeat < options.repeats; ++repeat)
    {
        own.seed = params.seed + repeat;
        addScene(options.scene(problem, options.size, part, repeat), own);
    }
}

void SearchBound::addScene(const Scene& scene, const Params& params)
{
    const cv::Ptr<Usac> counted = createUsac(scene, params);
    const Components original = counted->components();
    if (original.score->wholeModel())
        throw std::runtime_error(
            method + ": its quality needs all points at once; tested points cannot be counted");
    const cv::Ptr<CountingSolver> solver = cv::makePtr<CountingSolver>(original.minimalSolver);
    const cv::Ptr<CountingVerifier> verifier = cv::makePtr<CountingVerifier>(original.verifier);
    counted->components().minimalSolver = solver;
    counted->components().verifier = verifier;
    Report expected;
    counted->run(cv::noArray(), &expected);

    Arena arena;
    const Context context(counted->points(), original, params, arena);
    original.start(context);
    const double never = std::numeric_limits<double>::infinity();
    double search = never, solving = never, kernel = never;
    int found = 0;
    for (int round = 0; round < ROUNDS; ++round)
    {
        Report report;
        createUsac(scene, params)->run(cv::noArray(), &report);
        if (report.iterations != expected.iterations || report.models != expected.models ||
            report.cost != expected.cost)
            throw std::runtime_error(method + ": the counting components have changed the run");
        search = std::min(search, report.searchMs);
        solving = std::min(solving, solverMsOf(*counted, *original.minimalSolver, *solver, found));
        if (found != solver->modelsOfAll())
            throw std::runtime_error(method +
                                     ": the solver alone finds a different number of models");
        kernel = std::min(kernel, kernelMsOf(context, solver->models()));
    }
    // The solver also records samples that the final polishing solves, which are not of the search.
    const int solvedHere = expected.iterations - expected.rejectedSamples;
    const double solverMsOfOne = solver->solved() ? solving / solver->solved() : 0;
    samples += expected.iterations;
    solved += solvedHere;
    models += expected.models;
    points += verifier->tested();
    searchMs += search;
    solverMs += solverMsOfOne * solvedHere;
    kernelMs += kernel * verifier->tested();
    allSolverMs += solverMsOfOne * expected.iterations;
}

void SearchBound::markdownHeader(std::ostream& out)
{
    out << "\n## Search and its lower bound\n\n"
           "Solved: samples that reach the solver. Points: mean number of points that a model was "
           "tested with. Bound: time of the solver alone for the solved samples + time of the "
           "kernel alone for all tested points. Ratio: search / bound; last column: the same with "
           "a bound in which all drawn samples count as solved.\n\n"
           "| problem | method | matches | right | samples | solved | models | points | search ms "
           "| solver us a sample "
           "| "
           "kernel ns a point | bound ms | ratio | ratio, all samples |\n"
           "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
}

void SearchBound::markdown(std::ostream& out) const
{
    const double all = allSolverMs + kernelMs;
    out << "| " << letterOf(problem) << " | " << method << " | " << options.size
        << cv::format(" | %g | ", part) << samples << " | " << solved << " | " << models << " | "
        << perUnit((double)points, models, 1) << " | " << cv::format("%.4g", searchMs) << " | "
        << perUnit(solverMs, solved, 1e3) << " | " << perUnit(kernelMs, points, 1e6) << " | "
        << cv::format("%.4g | %.2f | %.2f |\n", boundMs(), searchMs / boundMs(), searchMs / all);
}

void SearchBound::csvHeader(std::ostream& out)
{
    out << "problem,method,size,inliers,scenes,samples,solved,models,points,search_ms,solver_ms,"
           "kernel_ms,bound_ms,"
           "ratio\n";
}

void SearchBound::csv(std::ostream& out) const
{
    out << letterOf(problem) << ",\"" << method << "\"," << options.size << ',' << part << ','
        << options.repeats << ',' << samples << ',' << solved << ',' << models << ',' << points
        << cv::format(",%.6g,%.6g,%.6g,%.6g,%.4f\n", searchMs, solverMs, kernelMs, boundMs(),
                      searchMs / boundMs());
}

}  // namespace benchmark
