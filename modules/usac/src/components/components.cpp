// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "control/watch.hpp"

namespace cv {
namespace usacv20 {

// The destructors are defined here so that the virtual table of each class is emitted only once, in
// this library, and not in other libraries that use the class.
Component::~Component() {}
Ordering::~Ordering() {}
bool Ordering::informative(const Context&) const { return true; }
Neighborhood::~Neighborhood() {}
int Neighborhood::mostEdges() const { return -1; }
bool Neighborhood::edgesOfFirstPoints() const { return false; }
Sampler::~Sampler() {}
MinimalSolver::~MinimalSolver() {}

void MinimalSolver::solveMany(const Correspondences& points, const int* const* samples, int count,
                              Model* const* models, int* found) const
{
    for (int i = 0; i < count; ++i)
        found[i] = solve(points, samples[i], models[i]);
}

int MinimalSolver::together() const { return 1; }

NonMinimalSolver::~NonMinimalSolver() {}
Residual::~Residual() {}
Score::~Score() {}
Verifier::~Verifier() {}
Degeneracy::~Degeneracy() {}
LocalOptimizer::~LocalOptimizer() {}
Termination::~Termination() {}
Polisher::~Polisher() {}
double Polisher::support(const Context&, const float*) const { return 0; }
double Polisher::weight(double, int) const { return 1; }
Usac::~Usac() {}

namespace {

//! Time per point to sort the points, in point tests of 2 ns (see Watch). For a million points,
//! sorting by scores takes 130 ns per point, and by density 80 ns. The value only affects when a
//! run with a time limit skips this step or ends.
constexpr double SORT_WORK = 65;

}  // namespace

void State::sort(const Context& context)
{
    const int size = context.points.size;
    int* const sorted = context.arena.take<int>(size);
    for (int i = 0; i < size; ++i)
        sorted[i] = i;
    const double work = size * SORT_WORK;  // without time to sort, the order is 0, 1, 2, ..., which
                                           // is a random order, because the points are shuffled
    const bool timely = !context.watch || (context.watch->fits(work) && !context.watch->stop(work));
    if (context.components.ordering && timely)
        context.components.ordering->sort(context, sorted);
    order = sorted;
}

namespace {

template <class T>
void startPart(const Ptr<T>& part, const Context& context)
{
    if (part)
        part->start(context);
}

template <class T>
void startParts(const std::vector<Ptr<T>>& parts, const Context& context)
{
    for (size_t i = 0; i < parts.size(); ++i)
        startPart(parts[i], context);
}

}  // namespace

void Component::start(const Context&) {}

void Components::start(const Context& context) const
{
    startPart(residual, context);
    startPart(score, context);
    startPart(ordering, context);
    startPart(neighborhood, context);
    startPart(sampler, context);
    startPart(minimalSolver, context);
    startPart(nonMinimalSolver, context);
    startParts(degeneracies, context);
    startPart(verifier, context);
    startPart(localOptimizer, context);
    startParts(terminations, context);
    startPart(polisher, context);
}

double Context::inlierThreshold() const
{
    return components.score ? points.threshold * components.score->inlierPart() : points.threshold;
}

double Context::randomInlierRatio() const
{
    return points.problem->randomInlierRatio(points) *
           std::pow(inlierThreshold() / points.threshold, points.problem->errorDimension());
}

bool Context::mustStop() const
{
    constexpr double FIT = 2000;  // about the time of a fit to a subset of the points, in point
                                  // tests of 2 ns, the unit of Watch
    return watch->stop(points.size + FIT);
}

bool Context::mustStop(double work) const { return watch->stop(work); }
bool Context::mustStopBefore(double work) const { return watch->stopBefore(work); }

Neighborhood& Context::neighborhood() const
{
    if (!components.neighborhood)
        CV_Error(Error::StsNullPtr, "components().neighborhood: it is empty, but the sampler or "
                                    "the local optimizer needs one");
    return *components.neighborhood;
}

const NonMinimalSolver& Context::nonMinimalSolver() const
{
    if (!components.nonMinimalSolver)
        CV_Error(Error::StsNullPtr, "components().nonMinimalSolver: it is empty, but the local "
                                    "optimizer or the polisher needs one");
    return *components.nonMinimalSolver;
}

const ResidualKernels* Residual::kernels() const { return 0; }
bool Residual::homogeneous() const { return true; }

int Residual::error(const Model& model, const double* datum, double* error) const
{
    const double* columns[MAX_COLUMNS];  // columns with a single datum; the residual reads only as
                                         // many columns as there are numbers in the datum
    for (int k = 0; k < MAX_COLUMNS; ++k)
        columns[k] = datum + k;
    squaredErrors(model, columns, 1, error);
    *error = std::sqrt(*error);
    return 1;
}

int Residual::linearize(const Model& model, const double* datum, double* error,
                        double* derivative) const
{
    // the step that balances rounding and truncation errors of central differences
    const double step = std::cbrt(DBL_EPSILON) *
                        std::sqrt(normL2Sqr<double, double>(model.val, model.size()));
    double above[MAX_COMPONENTS], below[MAX_COMPONENTS];
    const int components = this->error(model, datum, error);
    for (int j = 0; j < model.size(); ++j)
    {
        Model moved = model;
        moved.val[j] = model.val[j] + step;
        this->error(moved, datum, above);
        moved.val[j] = model.val[j] - step;
        this->error(moved, datum, below);
        for (int k = 0; k < components; ++k)
            derivative[model.size() * k + j] = (above[k] - below[k]) / (2 * step);
    }
    return components;
}

double Sampler::growingShare(const Context&) const { return 0; }
FusedKernel Score::fused(const Residual&) const { return 0; }
bool Score::wholeModel() const { return false; }
bool Score::countsInliers() const { return false; }
bool Score::usesThreshold() const { return true; }
double Score::inlierPart() const { return 1; }
double Score::threshold(const Context& context, const Model&) const
{
    return context.points.threshold;
}

bool Verifier::preTest(const Context&, const Model&, Rng&, int& inliers, int& tested) const
{
    inliers = tested = 0;
    return true;
}

double Verifier::keptProbability(const Context&, double, bool) const { return 1; }

bool Degeneracy::validSample(const Context&, const int*) const { return true; }
void Degeneracy::validSamples(const Context& context, const int* const* samples, int count,
                              bool* valid) const
{
    for (int i = 0; i < count; ++i)
        valid[i] = validSample(context, samples[i]);
}

bool Degeneracy::mayBeGood(const Context&, const int*) const { return false; }
bool Degeneracy::validModel(const Context&, const int*, const Model&) const { return true; }
bool Degeneracy::recover(const Context&, State&, const int*, Model&, Quality&) { return true; }
void Degeneracy::thresholdChanged(const Context&) {}

void Degeneracy::discount(const Context&, const Model&, Quality&) {}
double Degeneracy::successProbability(const Context&, const State&, const Model&) { return 1; }

bool Termination::countsAll() const { return true; }
bool Termination::adapt(const Context&, State&) { return false; }
int Termination::reason() const { return STOP_CUSTOM; }

}  // namespace usacv20
}  // namespace cv
