// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLE_GROUP_HPP
#define OPENCV_USACV20_SAMPLE_GROUP_HPP

#include "components/check_components.hpp"

namespace cv {
namespace usacv20 {

//! A few samples and their models, which are computed together, because this takes less time than
//! one by one (MinimalSolver::solveMany).
struct SampleGroup
{
    enum { SIZE = 4 };

    //! Computes the models of the first `count` samples.
    void solve(const MinimalSolver& solver, const Correspondences& points, int count)
    {
        const int* drawn[SIZE];
        Model* solved[SIZE];
        for (int i = 0; i < count; ++i)
        {
            drawn[i] = samples[i];
            solved[i] = models[i];
        }
        solver.solveMany(points, drawn, count, solved, found);
        for (int i = 0; i < count; ++i)
            checkModels(models[i], found[i]);
    }

    int samples[SIZE][MAX_SAMPLE_SIZE];
    Model models[SIZE][MAX_MODELS];
    int found[SIZE];  //!< number of models of each sample
};

}  // namespace usacv20
}  // namespace cv

#endif
