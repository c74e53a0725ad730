// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/instruction_set.hpp"
#include "lanes/lane_kernels.inl.hpp"
#include "lanes/lane_solver.hpp"

namespace cv {
namespace usacv20 {

namespace lanes {

Kernels baselineKernels() { return allKernels(); }

//! @param widest true: AVX-512 is allowed; it is slower than AVX2 if there are few samples
static Kernels bestKernels(bool widest)
{
    const InstructionSet instructions = fastestInstructions();
#ifdef USACV20_HAVE_AVX512
    if (instructions == INSTRUCTIONS_AVX512 && widest)
        return avx512Kernels();
#endif
#ifdef USACV20_HAVE_AVX2
    if (instructions >= INSTRUCTIONS_AVX2)
        return avx2Kernels();
#endif
    CV_UNUSED(instructions);
    CV_UNUSED(widest);
    return baselineKernels();
}

const Kernels& kernelsFor(int samples)
{
    static const Kernels few = bestKernels(false), many = bestKernels(true);
    return samples <= 4 ? few : many;  // AVX2 solves 4 samples at once
}

}  // namespace lanes

int LaneSolver::solve(const Correspondences& points, const int* sample, Model* models) const
{
    int found = 0;
    solveMany(points, &sample, 1, &models, &found);
    return found;
}

void LaneSolver::solveMany(const Correspondences& points, const int* const* samples, int count,
                           Model* const* models, int* found) const
{
    for (int first = 0; first < count; first += MAX_TOGETHER)
    {
        double matrices[MAX_TOGETHER][MAX_MODELS][9];
        const int end = std::min(first + MAX_TOGETHER, count);
        const SolverKernel solver = kernelOf(lanes::kernelsFor(end - first));
        solver(points, samples + first, end - first, matrices, found + first);
        for (int i = first; i < end; ++i)
            for (int k = 0; k < found[i]; ++k)
                models[i][k] = Matx33d(matrices[i - first][k]);
    }
}

}  // namespace usacv20
}  // namespace cv
