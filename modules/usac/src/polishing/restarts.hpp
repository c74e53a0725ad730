// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESTARTS_HPP
#define OPENCV_USACV20_RESTARTS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Fits to the inliers of a polished model from other starting points, if there are at most
#MOST inliers.

The sum of squared errors has local minima. A search that has rated thousands of models has usually
found the best minimum. A search that ends after its first sample might have missed it, for example
because there are only ten points, whose errors are below a wide threshold under any model.
Orientation checks make this worse if they reject right models: for an H whose horizon lies between
the points, they reject all samples except those with all points on one side of the horizon, which
might all lead to one wrong minimum.

Least squares over the inliers starts from the models of random samples of inliers, including models
that the degeneracy checks reject. A clearly lower minimum is polished and replaces the model if its
cost is not higher. If the fit starts from a rejected model, the minimum must be much lower: more
models are rejected than accepted, so that one of the rejected models reaches a lower minimum by
chance more often. */
class Restarts
{
public:
    //! @param context context in which models are polished and rated
    //! @param polisher polishes the results of the fits
    Restarts(const Context& context, Polisher& polisher);

    //! Replaces a polished model with a better model if such a model is found.
    void improve(Model& model);

private:
    enum {
        MOST = 30,  //!< maximum number of inliers; if there are more, nothing is done
        STEPS = 20  //!< maximum number of steps of a fit
    };

    //! Finds the inliers. @return false if they are too few or too many
    bool look(const Model& model);
    //! Tries fits that start from the model itself and from samples of inliers.
    void restart(Model& model);
    void draw(int index, int* sample) const;
    //! Least squares, starting from the best of the `found` models of a sample.
    //! @param known squared errors of the inliers at a minimum that is already known; may be null
    //! @return false if the fits lead to the known minimum
    bool tryModels(const int* sample, Model* models, int found, const double* known, Model& model);
    //! Least squares, starting from `model`. False if the fit leads to the known minimum or fails,
    //! unless the inliers are only a sample.
    bool fitOther(const double* known, Model& model) const;
    //! True if the degeneracy checks accept a sample and its model.
    bool isValid(const int* sample, const Model& model) const;
    //! Degrees of freedom that are left after a fit.
    int freedom() const;
    //! Squared errors of the inliers.
    void errorsOf(const Model& model, double* errors) const;
    //! The loss of a model: the sum of the squared errors of the inliers, in squared thresholds,
    //! each capped at 1.
    double lossOf(const Model& model) const;
    //! Least squares, starting from `model`. @return false if the inliers do not determine a model
    bool fit(Model& model, int steps = STEPS) const;
    //! Polishes a fit. The result replaces the model if the loss of the fit, before and after
    //! polishing, is below `limit`, the checks accept the result, and its cost is not higher than
    //! that of the model.
    void accept(const Model& fitted, double limit, Model& model);
    //! Lets the degeneracy checks update model and quality. False if they reject the model.
    bool check(Model& model, Quality& quality);

    const Context& context;
    const Components& parts;
    Polisher& polisher;
    State state;        //!< for the degeneracy checks; `bestQuality` is that of the present model
    const int m;        //!< sample size
    int inliers[MOST];  //!< of the model with which a round of fits begins
    int count;          //!< number of inliers
    double loss;        //!< lossOf() of the present model
};

}  // namespace usacv20
}  // namespace cv

#endif
