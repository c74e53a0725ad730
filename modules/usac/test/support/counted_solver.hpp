// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_COUNTED_SOLVER_HPP
#define OPENCV_USACV20_TEST_COUNTED_SOLVER_HPP

#include "test_precomp.hpp"

namespace opencv_test {

//! Fits with another solver and counts the fits.
class CountedSolver : public NonMinimalSolver
{
public:
    explicit CountedSolver(const Ptr<NonMinimalSolver>& solver_)
        : fits(0), longFits(0), solver(solver_)
    {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        ++fits;
        longFits += iterations > 1;
        return solver->fit(points, indices, count, weights, model, iterations);
    }

    mutable int fits, longFits;  //!< all fits, and those of which more than one step is allowed

private:
    const Ptr<NonMinimalSolver> solver;
};

}  // namespace opencv_test

#endif
