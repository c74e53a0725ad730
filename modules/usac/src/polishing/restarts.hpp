// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESTARTS_HPP
#define OPENCV_USACV20_RESTARTS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Fits to the inliers of a polished model from other starting points, if the inliers are
few or the threshold is wide (a point is an inlier of a wrong model with a probability of at least
0.2).

The sum of squared errors has local minima. A search that has rated thousands of models has usually
found the best minimum. A search that ends after its first sample might have missed the best
minimum, for example because there are only ten points, whose errors are below a wide threshold
under any model.
Orientation checks make this worse if they reject right models: for an H whose horizon lies between
the points, they reject all samples except those with all points on one side of the horizon, which
might all lead to one wrong minimum.

Least squares over the inliers (at most #MOST) starts from the models of random samples of inliers,
including models that the degeneracy checks reject. A clearly lower minimum is polished and replaces
the model if its cost is not higher. If the fit starts from a rejected model, the minimum must be
much lower: more models are rejected than accepted, so that one of the rejected models reaches a
lower minimum by chance more often.

A few inliers close to each other determine the model poorly far from them. Therefore the outliers
with the smallest errors are tried, too. A fit to the inliers and one such outlier replaces the
model if its loss over these points (lossOf()) is lower than that of the model and if its cost is
not higher. If the fit starts from the model, the outlier must also increase the loss only a
little. */
class Restarts
{
public:
    /** @param search context of the search, whose points the minimal solver and the checks use
    @param polish context in which models are polished and rated; its points are the points of
    `search` or, if the lens has distortion, the original image points
    @param state state of the run */
    Restarts(const Context& search, const Context& polish, State& state);

    //! Replaces a polished model with a better model if such a model is found.
    //! @param quality quality of the model in the context `polish`
    void improve(Model& model, Quality& quality);

    /** To be called if the search has found no model, for example because the checks have rejected
    all samples: if there are at most #MOST points, finds a model that fits all points better than
    the model of random points would. @return false if no such model is found */
    bool begin(Model& model, Quality& quality);

private:
    enum {
        //! Maximum number of inliers that are used. If there are more inliers, nothing is done
        //! unless the threshold is wide.
        MOST = 30,
        //! Maximum number of outliers that are tried.
        NEXT = 4,
        //! Maximum number of steps of a fit.
        STEPS = 20
    };

    //! Finds the inliers, and the outliers with the smallest errors. @return false if there are too
    //! few inliers, or more than #MOST and the threshold is not wide
    bool look(const Model& model);
    //! Tries fits to the inliers that start from samples of inliers and from the model itself.
    void restartInliers(Model& model, Quality& quality);
    //! Fits the inliers together with one outlier at a time, starting from the model and from
    //! samples that contain this outlier. Does nothing if there are more than #NEXT outliers.
    void restartOutside(Model& model, Quality& quality);
    //! Fits the inliers together with one outlier at a time, starting from the model.
    void extendInliers(Model& model, Quality& quality);
    //! Tries samples of the first `size` members in turn until one of them has replaced the model.
    //! @param index, end input: numbers of the first sample and of the one after the last sample,
    //! which select the random numbers; output: `index` is the number of the next sample
    //! @param known squared errors of the members at a minimum that is already known; may be null
    //! @return true if the model was replaced
    bool restart(int& index, int end, int size, const double* known, Model& model,
                 Quality& quality);
    //! Draws a sample of the first `size` members. If an outlier is among them, the sample contains
    //! it.
    void draw(int index, int size, int* sample) const;
    //! Least squares over the first `size` members, starting from the best of the `found` models of
    //! a sample. @return true if the model was replaced
    bool tryModels(const int* sample, Model* models, int found, int size, const double* known,
                   Model& model, Quality& quality);
    //! Least squares over the first `size` members, starting from `model`. False if the fit leads
    //! to the known minimum or fails, unless the members are only a sample.
    bool fitOther(int size, const double* known, Model& model) const;
    //! True if the degeneracy checks accept a sample and its model.
    bool isValid(const int* sample, const Model& model) const;
    //! Least squares over the inliers and one outlier, starting from the model; only for errors
    //! with several components. @return true if the model was replaced
    bool extend(int outside, Model& model, Quality& quality);
    //! Degrees of freedom that are left after a fit to `size` points.
    int freedom(int size) const;
    //! Squared errors of the first `size` members.
    void errorsOf(const Model& model, int size, double* errors) const;
    //! The loss of a model: the sum of the squared errors of the first `size` members, in squared
    //! thresholds, each capped at 1.
    double lossOf(const Model& model, int size) const;
    //! Least squares over the first `size` members, starting from `model`. @return false if the
    //! members do not determine a model
    bool fit(int size, Model& model, int steps = STEPS) const;
    //! Polishes a fit. The result replaces the model if the loss of the fit, before and after
    //! polishing, is below `limit`, the checks accept the result, and its cost is not higher than
    //! that of the model. @return true if the model was replaced
    bool accept(const Model& fitted, int size, double limit, Model& model, Quality& quality);
    //! Lets the degeneracy checks update model and quality. False if they reject the model.
    bool check(Model& model, Quality& quality);

    const Context& search;
    const Context& context;
    const Components& parts;
    State& state;
    const int m;            //!< sample size
    int members[MOST + 1];  //!< inliers that are used, followed by an outlier if one is tried
    int next[NEXT];         //!< outliers with the smallest errors, in ascending order of the error
    int count, all;         //!< number of inliers in `members`, and of all inliers
    int outside;            //!< number of outliers in `next`
    double loss;            //!< lossOf() of the present model
};

}  // namespace usacv20
}  // namespace cv

#endif
