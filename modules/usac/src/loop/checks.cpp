// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/checks.hpp"

namespace cv {
namespace usacv20 {

namespace {

Degeneracy* const* pointersTo(const std::vector<Ptr<Degeneracy>>& checks, Arena& arena)
{
    Degeneracy** const result = arena.take<Degeneracy*>(checks.size());
    for (size_t d = 0; d < checks.size(); ++d)
        result[d] = checks[d].get();
    return result;
}

}  // namespace

Checks::Checks(const Context& context_, State& state_)
    : context(context_), state(state_),
      checks(pointersTo(context_.components.degeneracies, context_.arena)),
      count((int)context_.components.degeneracies.size())
{}

int Checks::acceptSamples(const int** samples, int sampleCount) const
{
    int left = sampleCount;
    for (int d = 0; left > 0 && d < count; ++d)
    {
        bool valid[MinimalSolver::MAX_TOGETHER];
        checks[d]->validSamples(context, samples, left, valid);
        int accepted = 0;
        for (int i = 0; i < left; ++i)
        {
            samples[accepted] = samples[i];
            accepted += valid[i];
        }
        left = accepted;
    }
    return left;
}

bool Checks::validModel(const int* sample, const Model& model) const
{
    bool valid = true;
    for (int d = 0; valid && d < count; ++d)
        valid = checks[d]->validModel(context, sample, model);
    return valid;
}

bool Checks::mayBeGood(const int* sample) const
{
    bool maybe = false;
    for (int d = 0; !maybe && d < count; ++d)
        maybe = checks[d]->mayBeGood(context, sample);
    return maybe;
}

bool Checks::recover(const int* sample, Model& model, Quality& quality) const
{
    for (int d = 0; d < count; ++d)
        if (!checks[d]->recover(context, state, sample, model, quality))
            return false;
    quality = discounted(model, quality);
    return true;
}

Quality Checks::discounted(const Model& model, const Quality& rated) const
{
    Quality quality = rated;
    for (int d = 0; d < count; ++d)
        checks[d]->discount(context, model, quality);
    return quality;
}

void Checks::updateSuccessProbability(const Model& model) const
{
    state.successProbability = 1;
    if ((context.params.termination & TERMINATION_EXACT) == 0)
        return;
    for (int d = 0; d < count; ++d)
        state.successProbability *= checks[d]->successProbability(context, state, model);
}

void Checks::thresholdChanged() const
{
    for (int d = 0; d < count; ++d)
        checks[d]->thresholdChanged(context);
}

}  // namespace usacv20
}  // namespace cv
