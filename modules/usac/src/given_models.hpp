// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GIVEN_MODELS_HPP
#define OPENCV_USACV20_GIVEN_MODELS_HPP

#include "core/point_subset.hpp"
#include "problem_data.hpp"

namespace cv {
namespace usacv20 {

/** @brief What needs no search: least squares over given points, errors under a given model. For
Usac::fit, refine and errors. */
class GivenModels
{
public:
    /** @param context points, components (which have been told of a run) and options
    @param data the points
    @param imageResidual that of Problem::createImageResidual, and its least squares; empty: none */
    GivenModels(const Context& context, ProblemData& data, const Ptr<Residual>& imageResidual,
                const Ptr<NonMinimalSolver>& imageFit);

    Mat fit(InputArray weights, InputArray chosen, OutputArray mask, Report* report);
    Mat refine(InputArray model, InputArray chosen, OutputArray mask, Report* report);
    Mat errors(InputArray model) const;

    //! A model of the caller's in the coordinates of the mask. @param forSearch output, the same
    //! for the search; may be null
    Model read(InputArray given, Model* forSearch) const;
    //! State::best as Usac::run returns it, if State::report has #STOP_NO_SEARCH.
    Mat give(State& state, OutputArray mask, Report* report);

private:
    //! Reads which points take part, and their weights.
    void choose(InputArray weights, InputArray chosen);
    //! The best of the models of samples, after least squares over a part of the points.
    bool begin(Model& model) const;
    //! The sum of (weighted) squared errors over the first points that take part.
    double lossOf(PointSubset& part, const Model& model) const;
    bool leastSquares(int size, Model& model) const;

    const Context& context;
    ProblemData& data;
    const Ptr<Residual> residual;  //!< that of the mask
    const bool asSeen;             //!< it is one of the points as they were seen
    const Correspondences points;  //!< those of the residual
    const NonMinimalSolver& solver;
    const Problem& problem;
    const int64 start;
    int* indices;     //!< of the points that take part
    double* weights;  //!< theirs; null: all 1
    int count;
};

}  // namespace usacv20
}  // namespace cv

#endif
