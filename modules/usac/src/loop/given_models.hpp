// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GIVEN_MODELS_HPP
#define OPENCV_USACV20_GIVEN_MODELS_HPP

#include "components/point_subset.hpp"
#include "input/problem_data.hpp"

namespace cv {
namespace usacv20 {

/** @brief Implements Usac::fit, Usac::refine (if the caller gives a mask of the inliers) and
Usac::errors: least squares over points that the caller chooses, and errors under a model that the
caller gives. */
class GivenModels
{
public:
    /** @param context points, components (already started) and options
    @param data the points; fit() and refine() set their threshold
    @param imageResidual result of Problem::createImageResidual; can be empty
    @param imageFit the least-squares solver for `imageResidual`; empty: the solver of `context`,
    which fits the residual of `context` */
    GivenModels(const Context& context, ProblemData& data, const Ptr<Residual>& imageResidual,
                const Ptr<NonMinimalSolver>& imageFit);

    Mat fit(InputArray weights, InputArray chosen, OutputArray mask, Report* report);
    Mat refine(InputArray model, InputArray chosen, OutputArray mask, Report* report);
    Mat errors(InputArray model) const;

    //! Converts a model of the caller to the coordinates of Problem::toModelCoordinates. Raises
    //! cv::Exception if it is not a model of the problem.
    //! @param forSearch output, the same model in the coordinates of the search; can be null
    Model read(InputArray given, Model* forSearch) const;
    //! Returns State::best in the form in which Usac::run returns models if Report::stop is
    //! #STOP_NO_SEARCH, otherwise an empty matrix. Also fills the mask and the report.
    Mat give(State& state, OutputArray mask, Report* report);

private:
    //! Reads from the arguments of the caller which points are used, and their weights.
    void choose(InputArray weights, InputArray chosen);
    //! Finds an initial model: the best models of some samples are fitted to a subset of the
    //! points, and the fit with the lowest loss is used. @return false if no model is found
    bool begin(Model& model) const;
    //! The loss: the sum of the (weighted) squared errors of the points in `part`.
    double lossOf(PointSubset& part, const Model& model) const;
    bool leastSquares(int size, Model& model) const;
    //! Finds the best model of the minimal solver for the points, which must be as many as in a
    //! minimal sample. They determine the model even if the least-squares solver needs more points.
    //! @return false if there is no model
    bool solveExactly(Model& model) const;
    //! Sets the threshold of the mask, if there is a model.
    void setThreshold(const State& state);
    //! Report::cost of a model.
    double costOf(const Model& model) const;

    const Context& context;
    ProblemData& data;
    const Ptr<Residual> residual;  //!< residual from which the mask is computed
    const bool asSeen;             //!< true if `residual` is for the original image points
    const Ptr<Residual> fitted;    //!< residual that the fits minimize; its points are `points`
    const Correspondences points;  //!< the points, in the coordinates of `fitted`
    const Ptr<NonMinimalSolver> solver;  //!< empty: the solver of `context`
    const Problem& problem;
    const int64 start;
    int* indices;     //!< indices of the points that are used
    double* weights;  //!< weights of these points; null: all weights are 1
    int count;        //!< number of points that are used
};

}  // namespace usacv20
}  // namespace cv

#endif
