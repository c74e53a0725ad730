// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/restarts.hpp"
#include "numeric/selection.hpp"
#include "components/sample_group.hpp"
#include "components/streams.hpp"

namespace cv {
namespace usacv20 {

namespace {

// doc/measurements/constants_tables.md lists the effects of halving or doubling each constant.

//! Number of samples from which fits start: RESTARTS samples of inliers and, for each outlier that
//! is tried, RESTARTS_OUTSIDE samples of this outlier and inliers.
constexpr int RESTARTS = 16, RESTARTS_OUTSIDE = 8;
//! The threshold is wide if a point is an inlier of a wrong model with at least this probability.
constexpr double WIDE = 0.2;
//! The loss (see lossOf()) of another minimum must be below this fraction of the model's loss.
constexpr double CLEAR = 0.9;
/** A minimum reached from a model that the degeneracy checks reject must have an even lower loss:
the probability that the loss decreases so much by chance must be at most UNLIKELY. This probability
is estimated as the ratio of the new to the old loss, raised to the power of half the degrees of
freedom that are left after the fit. */
constexpr double UNLIKELY = 0.1;
//! begin() accepts a model only if its loss is so low that a model of random points has such a low
//! loss with at most this probability.
constexpr double CHANCE = 1e-6;
//! A fit that starts from a sample ends if the errors after one of its first FIRST_STEPS steps
//! differ from those of the known minimum, on average, by at most the fraction SAME: it would only
//! lead to this minimum. Fits that lead to another minimum differ by more than ten times as much.
constexpr int FIRST_STEPS = 2;
constexpr double SAME = 0.1;
//! Maximum increase of the loss by an additional point, per component of its error and in units of
//! the inliers' loss per degree of freedom. If ten degrees of freedom are left, the increase
//! exceeds 8 for one right point in a hundred.
constexpr double GROWN = 8;
//! Number of points whose errors are computed together. The value has no effect on the result.
constexpr int ERROR_BLOCK = 128;

}  // namespace

Restarts::Restarts(const Context& search_, const Context& polish, State& state_)
    : search(search_), context(polish), parts(polish.components), state(state_),
      m(parts.minimalSolver->sampleSize()), count(0), all(0), outside(0), loss(0)
{}

void Restarts::improve(Model& model, Quality& quality)
{
    if (!parts.nonMinimalSolver || !look(model))
        return;
    // the threshold can have changed after the search
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        parts.degeneracies[d]->thresholdChanged(search);
    for (int before = 0; before < count && !context.stop(); look(model))
    {
        before = count;
        restartInliers(model, quality);
        restartOutside(model, quality);
        extendInliers(model, quality);
    }
}

void Restarts::restartInliers(Model& model, Quality& quality)
{
    Model here = model;
    double known[MOST + 1];
    const bool fitted = fit(count, here);
    if (fitted)
    {
        errorsOf(here, count, known);
        accept(here, count, CLEAR * loss, model, quality);
    }
    const int end = count > m ? RESTARTS : 1;
    for (int i = 0; i < end;)
        restart(i, end, count, fitted ? known : 0, model, quality);
}

void Restarts::restartOutside(Model& model, Quality& quality)
{
    if (context.points.size - all > NEXT)
        return;
    for (int i = 0; i < outside * RESTARTS_OUTSIDE && !context.stop();)
    {
        const int other = i / RESTARTS_OUTSIDE;
        members[count] = next[other];
        Model here = model;
        double known[MOST + 1];
        const bool fitted = fit(count + 1, here);
        if (fitted)
            errorsOf(here, count + 1, known);
        if (fitted && accept(here, count + 1, CLEAR * (loss + 1), model, quality))
        {
            look(model);
            ++i;
            continue;
        }
        int index = RESTARTS + i;
        if (restart(index, RESTARTS + (other + 1) * RESTARTS_OUTSIDE, count + 1, fitted ? known : 0,
                    model, quality))
            look(model);
        i = index - RESTARTS;
    }
}

void Restarts::extendInliers(Model& model, Quality& quality)
{
    for (int i = 0; i < outside && freedom(count) > 0 && !context.stop(); ++i)
    {
        const int before = all;
        if (!extend(next[i], model, quality))
            continue;
        if (!look(model) || all <= before)
            return;
        i = -1;
    }
}

bool Restarts::begin(Model& model, Quality& quality)
{
    const Correspondences& p = context.points;
    if (!parts.nonMinimalSolver || p.size > MOST || freedom(p.size) <= 0)
        return false;
    count = p.size;
    for (int i = 0; i < count; ++i)
        members[i] = i;
    const double random = std::min(p.problem->randomInlierRatio(p), 1.);
    const double part = std::pow(std::pow(CHANCE, 1. / (count - m)) / random,
                                 2. / p.problem->errorDimension());
    loss = count * std::min(part, 1.);
    bool found = false;
    for (int i = 0; i < RESTARTS;)
        found |= restart(i, RESTARTS, count, 0, model, quality);
    return found;
}

bool Restarts::look(const Model& model)
{
    const Correspondences& p = context.points;
    const float limit = (float)(p.threshold * p.threshold);
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(p.size);
    int* const inliers = scope.take<int>(p.size);
    const bool wide = p.problem->randomInlierRatio(p) >= WIDE;
    count = outside = 0;
    for (int begin = 0; begin < p.size && (wide || count <= MOST); begin += ERROR_BLOCK)
    {
        const int end = std::min<int>(begin + ERROR_BLOCK, p.size);
        parts.residual->squaredErrors(p, model, begin, end, errors + begin);
        int found = count;
        for (int i = begin; i < end; ++i)  // without branches, which would often be mispredicted
        {
            inliers[found] = i;
            found += errors[i] <= limit;
        }
        count = found;
    }
    if (count < m || (count > MOST && !wide))
    {
        count = 0;
        return false;
    }
    Rng rng(context.params.seed, streamOf(STREAM_RESTARTS));
    const int size = std::min(count, (int)MOST);
    randomPart(inliers, count, size, rng);
    std::copy(inliers, inliers + size, members);
    for (int i = 0; i < p.size && count < MOST; ++i)
    {
        if (!(errors[i] > limit && errors[i] <= FLT_MAX))
            continue;
        int place = std::min(outside, (int)NEXT);
        for (; place > 0 && errors[i] < errors[next[place - 1]]; --place)
            if (place < NEXT)
                next[place] = next[place - 1];
        if (place < NEXT)
            next[place] = i;
        outside = std::min(outside + 1, (int)NEXT);
    }
    all = count;
    count = size;
    loss = lossOf(model, count);
    return true;
}

bool Restarts::restart(int& index, int end, int size, const double* known, Model& model,
                       Quality& quality)
{
    SampleGroup group;
    while (index < end)
    {
        const int number = std::min<int>(end - index, SampleGroup::SIZE);
        for (int i = 0; i < number; ++i)
            draw(index + i, size, group.samples[i]);
        group.solve(*parts.minimalSolver, search.points, number);
        for (int i = 0; i < number; ++i)
        {
            if (context.stop())
            {
                index = end;
                return false;
            }
            ++index;
            if (tryModels(group.samples[i], group.models[i], group.found[i], size, known, model,
                          quality))
                return true;
        }
    }
    return false;
}

void Restarts::draw(int index, int size, int* sample) const
{
    Rng rng(context.params.seed, streamOf(STREAM_RESTARTS, 1 + index));
    int places[MAX_SAMPLE_SIZE];
    rng.distinct(count, m, places);
    if (size > count)
        places[0] = count;
    for (int k = 0; k < m; ++k)
        sample[k] = members[places[k]];
}

bool Restarts::tryModels(const int* sample, Model* models, int found, int size, const double* known,
                         Model& model, Quality& quality)
{
    int best[2] = {-1, -1};  // best model that the checks reject, and best model that the checks
                             // accept
    double least[2] = {DBL_MAX, DBL_MAX};
    for (int k = 0; k < found; ++k)
    {
        const bool valid = isValid(sample, models[k]);
        const double own = lossOf(models[k], size);
        if (own < least[valid])
        {
            least[valid] = own;
            best[valid] = k;
        }
    }
    const double refused = std::min(CLEAR, std::pow(UNLIKELY, 2. / std::max(freedom(size), 0)));
    const double before = loss + size - count;
    bool better = false;
    for (int valid = 0; valid < 2; ++valid)
        if (best[valid] >= 0 && fitOther(size, known, models[best[valid]]))
            better |= accept(models[best[valid]], size, (valid ? CLEAR : refused) * before, model,
                             quality);
    return better;
}

bool Restarts::fitOther(int size, const double* known, Model& model) const
{
    for (int step = 0; known && step < FIRST_STEPS; ++step)
    {
        if (!fit(size, model, 1))
            return size == m;
        double errors[MOST + 1], sum = 0, difference = 0;
        errorsOf(model, size, errors);
        for (int k = 0; k < size; ++k)
        {
            sum += known[k];
            difference += std::abs(errors[k] - known[k]);
        }
        if (sum <= DBL_MAX && difference <= SAME * sum)
            return false;
    }
    return fit(size, model) || size == m;
}

bool Restarts::isValid(const int* sample, const Model& model) const
{
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        if (!parts.degeneracies[d]->validSample(search, sample) ||
            !parts.degeneracies[d]->validModel(search, sample, model))
            return false;
    return true;
}

bool Restarts::extend(int other, Model& model, Quality& quality)
{
    members[count] = other;
    const int degrees = context.points.problem->errorDimension();
    const double grown = loss * (1 + GROWN * degrees / freedom(count));
    Model fitted = model;
    return degrees > 1 && fit(count + 1, fitted) &&
           accept(fitted, count + 1, std::min(grown, loss + 1), model, quality);
}

int Restarts::freedom(int size) const
{
    const Problem& problem = *context.points.problem;
    return problem.errorDimension() * size - problem.dimension();
}

void Restarts::errorsOf(const Model& model, int size, double* errors) const
{
    double columns[MAX_COLUMNS][MOST + 1];
    const double* column[MAX_COLUMNS];
    for (int c = 0; c < context.points.numbers(); ++c)
    {
        for (int k = 0; k < size; ++k)
            columns[c][k] = context.points.exact[c][members[k]];
        column[c] = columns[c];
    }
    parts.residual->squaredErrors(model, column, size, errors);
}

double Restarts::lossOf(const Model& model, int size) const
{
    const double scale = 1 / (context.points.threshold * context.points.threshold);
    double errors[MOST + 1], sum = 0;
    errorsOf(model, size, errors);
    for (int k = 0; k < size; ++k)
    {
        const double part = errors[k] * scale;
        sum += part < 1 ? part : 1;  // NaN counts as 1
    }
    return sum;
}

bool Restarts::fit(int size, Model& model, int steps) const
{
    return parts.nonMinimalSolver->fit(context.points, members, size, 0, model, steps);
}

bool Restarts::accept(const Model& fitted, int size, double limit, Model& model, Quality& quality)
{
    if (!(lossOf(fitted, size) < limit))
        return false;
    Model candidate = fitted;
    parts.polisher->polish(context, candidate);
    candidate = context.points.problem->closest(candidate);
    if (!(lossOf(candidate, size) < limit))
        return false;
    const State before = state;
    Quality rated = context.rate(candidate), own = quality;
    Model checked = model;
    check(checked, own);
    if (!check(candidate, rated) || !(rated.cost <= own.cost) || !(lossOf(candidate, size) < limit))
    {
        state = before;
        return false;
    }
    model = candidate;
    quality = context.rate(candidate);
    loss = lossOf(model, count);
    return true;
}

bool Restarts::check(Model& model, Quality& quality)
{
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        if (!parts.degeneracies[d]->recover(search, state, 0, model, quality))
            return false;
    for (size_t d = 0; d < parts.degeneracies.size(); ++d)
        parts.degeneracies[d]->discount(search, model, quality);
    return true;
}

}  // namespace usacv20
}  // namespace cv
