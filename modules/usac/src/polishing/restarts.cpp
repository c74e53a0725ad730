// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/restarts.hpp"
#include "components/sample_group.hpp"
#include "components/streams.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Number of samples of inliers from which fits start, at most: if all fits of a SampleGroup lead
//! to the known minimum, there are no more.
constexpr int RESTARTS = 16;
//! The loss (see lossOf()) of another minimum must be below this fraction of the model's loss.
constexpr double CLEAR = 0.9;
/** A minimum reached from a model that the degeneracy checks reject must have an even lower loss:
the probability that the loss decreases so much by chance must be at most UNLIKELY. This probability
is estimated as the ratio of the new to the old loss, raised to the power of half the degrees of
freedom that are left after the fit. */
constexpr double UNLIKELY = 0.1;
//! A fit that starts from a sample ends if the errors after one of its first FIRST_STEPS steps
//! differ from those of the known minimum, on average, by at most the fraction SAME: it would only
//! lead to this minimum. Fits that lead to another minimum differ by more than ten times as much.
constexpr int FIRST_STEPS = 2;
constexpr double SAME = 0.1;
//! Number of points whose errors are computed together. The value has no effect on the result.
constexpr int ERROR_BLOCK = 128;

}  // namespace

Restarts::Restarts(const Context& context_, Polisher& polisher_)
    : context(context_), parts(context_.components), polisher(polisher_),
      m(parts.minimalSolver->sampleSize()), count(0), loss(0)
{}

void Restarts::improve(Model& model)
{
    if (!look(model))
        return;
    state.rng = Rng(context.params.seed, streamOf(STREAM_RESTARTS));
    state.bestQuality = context.rate(model);
    // the threshold can have changed after the search
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        parts.degeneracies[d]->thresholdChanged(context);
    for (int before = 0; before < count && !context.stop(); look(model))
    {
        before = count;
        restart(model);
    }
}

bool Restarts::look(const Model& model)
{
    const Correspondences& p = context.points;
    const float limit = (float)(p.threshold * p.threshold);
    float errors[ERROR_BLOCK];
    count = 0;
    for (int begin = 0; begin < p.size; begin += ERROR_BLOCK)
    {
        const int end = std::min<int>(begin + ERROR_BLOCK, p.size);
        parts.residual->squaredErrors(p, model, begin, end, errors);
        for (int i = begin; i < end; ++i)
        {
            if (!(errors[i - begin] <= limit))
                continue;
            if (count == MOST)
            {
                count = 0;
                return false;
            }
            inliers[count++] = i;
        }
    }
    if (count < m)
        count = 0;
    loss = lossOf(model);
    return count > 0;
}

void Restarts::restart(Model& model)
{
    Model here = model;
    double errors[MOST];
    const double* known = 0;
    if (fit(here))
    {
        errorsOf(here, errors);
        known = errors;
        accept(here, CLEAR * loss, model);
    }
    const int end = count > m ? RESTARTS : 1;
    SampleGroup group;
    bool others = true;
    for (int first = 0; others && first < end; first += SampleGroup::SIZE)
    {
        others = false;
        const int number = std::min<int>(end - first, SampleGroup::SIZE);
        for (int i = 0; i < number; ++i)
            draw(first + i, group.samples[i]);
        group.solve(*parts.minimalSolver, context.points, number);
        for (int i = 0; i < number && !context.stop(); ++i)
            others = tryModels(group.samples[i], group.models[i], group.found[i], known, model) ||
                     others;
    }
}

void Restarts::draw(int index, int* sample) const
{
    Rng(context.params.seed, streamOf(STREAM_RESTARTS, 1 + index)).distinct(count, m, sample);
    for (int k = 0; k < m; ++k)
        sample[k] = inliers[sample[k]];
}

bool Restarts::tryModels(const int* sample, Model* models, int found, const double* known,
                         Model& model)
{
    int best[2] = {-1, -1};  // best model that the checks reject, and best model that the checks
                             // accept
    double least[2] = {DBL_MAX, DBL_MAX};
    for (int k = 0; k < found; ++k)
    {
        const bool valid = isValid(sample, models[k]);
        const double own = lossOf(models[k]);
        if (own < least[valid])
        {
            least[valid] = own;
            best[valid] = k;
        }
    }
    const double refused = std::min(CLEAR, std::pow(UNLIKELY, 2. / std::max(freedom(), 0)));
    const double before = loss;
    bool other = false;
    for (int valid = 0; valid < 2; ++valid)
        if (best[valid] >= 0 && fitOther(known, models[best[valid]]))
        {
            other = true;
            accept(models[best[valid]], (valid ? CLEAR : refused) * before, model);
        }
    return other;
}

bool Restarts::fitOther(const double* known, Model& model) const
{
    for (int step = 0; known && step < FIRST_STEPS; ++step)
    {
        if (!fit(model, 1))
            return count == m;
        double errors[MOST], sum = 0, difference = 0;
        errorsOf(model, errors);
        for (int k = 0; k < count; ++k)
        {
            sum += known[k];
            difference += std::abs(errors[k] - known[k]);
        }
        if (sum <= DBL_MAX && difference <= SAME * sum)
            return false;
    }
    return fit(model) || count == m;
}

bool Restarts::isValid(const int* sample, const Model& model) const
{
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        if (!parts.degeneracies[d]->validSample(context, sample) ||
            !parts.degeneracies[d]->validModel(context, sample, model))
            return false;
    return true;
}

int Restarts::freedom() const
{
    const Problem& problem = *context.points.problem;
    return problem.errorDimension() * count - problem.dimension();
}

void Restarts::errorsOf(const Model& model, double* errors) const
{
    double columns[MAX_COLUMNS][MOST];
    const double* column[MAX_COLUMNS];
    for (int c = 0; c < context.points.numbers(); ++c)
    {
        for (int k = 0; k < count; ++k)
            columns[c][k] = context.points.exact[c][inliers[k]];
        column[c] = columns[c];
    }
    parts.residual->squaredErrors(model, column, count, errors);
}

double Restarts::lossOf(const Model& model) const
{
    const double scale = 1 / (context.points.threshold * context.points.threshold);
    double errors[MOST], sum = 0;
    errorsOf(model, errors);
    for (int k = 0; k < count; ++k)
    {
        const double part = errors[k] * scale;
        sum += part < 1 ? part : 1;  // NaN counts as 1
    }
    return sum;
}

bool Restarts::fit(Model& model, int steps) const
{
    return parts.nonMinimalSolver->fit(context.points, inliers, count, 0, model, steps);
}

void Restarts::accept(const Model& fitted, double limit, Model& model)
{
    if (!(lossOf(fitted) < limit))
        return;
    Model candidate = fitted;
    polisher.polish(context, candidate);
    candidate = context.points.problem->closest(candidate);
    if (!(lossOf(candidate) < limit))
        return;
    Quality rated = context.rate(candidate), own = state.bestQuality;
    Model checked = model;
    check(checked, own);
    if (!check(candidate, rated) || !(rated.cost <= own.cost) || !(lossOf(candidate) < limit))
        return;
    model = candidate;
    state.bestQuality = context.rate(candidate);
    loss = lossOf(model);
}

bool Restarts::check(Model& model, Quality& quality)
{
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        if (!parts.degeneracies[d]->recover(context, state, 0, model, quality))
            return false;
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        parts.degeneracies[d]->discount(context, model, quality);
    return true;
}

}  // namespace usacv20
}  // namespace cv
