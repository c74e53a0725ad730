// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

// The destructors are here so that each class has one home for its virtual table, also in the libraries of users.
Prior::~Prior() {}
Neighbourhood::~Neighbourhood() {}
Sampler::~Sampler() {}
MinimalSolver::~MinimalSolver() {}
NonMinimalSolver::~NonMinimalSolver() {}
Residual::~Residual() {}
Score::~Score() {}
Verifier::~Verifier() {}
Degeneracy::~Degeneracy() {}
LocalOptimizer::~LocalOptimizer() {}
Termination::~Termination() {}
Polisher::~Polisher() {}
Usac::~Usac() {}

void State::sort(const Context& context)
{
    order.resize(context.points.size);
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = (int)i;
    if (context.components.prior)
        context.components.prior->sort(context, order);
}

Residual::Kind Residual::kind() const { return CUSTOM; }

FusedKernel Score::fused(const Residual&) const { return 0; }
bool Score::wholeModel() const { return false; }
double Score::threshold(const Context& context, const Model&) const { return context.points.threshold; }

bool Verifier::preTest(const Context&, const Model&, Rng&, int& inliers, int& tested) const
{
    inliers = tested = 0;
    return true;
}

bool Degeneracy::validSample(const Context&, const int*) const { return true; }
bool Degeneracy::mayBeGood(const Context&, const int*) const { return false; }
bool Degeneracy::validModel(const Context&, const int*, const Model&) const { return true; }
bool Degeneracy::recover(const Context&, State&, const int*, Model&, Quality&) { return true; }

bool Termination::countsAll() const { return true; }
int Termination::reason() const { return STOP_CUSTOM; }

} // namespace usacv20
} // namespace cv
