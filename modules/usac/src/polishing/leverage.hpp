// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LEVERAGE_HPP
#define OPENCV_USACV20_LEVERAGE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Corrects a polished model that is distorted by a few wrong matches of high leverage.

If the right matches hardly determine some parameters of a model (the epipole of F for a short
baseline), the model can be distorted to fit wrong matches as well. The errors of the right matches
then grow, but stay far below a threshold that is wide for the noise. Such a model has a lower cost
than the true model under every score, under the loss of every polisher, and even under the
likelihood of the true noise, so that no search can prefer the true model by its cost. But the wrong
matches alone determine these parameters. Therefore the wrong matches have a high leverage (the
fraction of a point's own error that the fit absorbs), and without the wrong matches, the other
inliers have another optimum with clearly lower errors.

Therefore the inliers with the highest leverage are left out. Fits to the remaining inliers start
from the model and from samples of these inliers. Points with small errors under the best fit are
included again, at first only points of low leverage, as in a forward search
@cite atkinson2000robust. A fit to all included points is polished. The result replaces the model on
two conditions:
- The errors of the included points that are inliers of the original model decrease by more than
chance explains.
- The inliers that the fit loses are not evidence against the fit. If the fit has k inliers fewer
than the original model, let p be the probability that a model has k or more additional inliers by
chance. Then p must be at least 1 / n^2 for n outliers, because the best of all models through two
outliers reaches such a p by chance. And the increase of the log-likelihood by the smaller errors
must be at least -log(p).

If most right matches are on a plane, the right matches off the plane have a high leverage, too. But
there are more of them than of wrong matches that fit one epipole by chance. If most inliers are on
a plane, the errors must decrease more, and E is not changed.

The method is used only for errors with one component: with more components, a wrong match is rarely
within the threshold by chance. To limit the time, the first fit uses at most #MOST inliers. Later
fits use only the first points, four times as many as were needed to find these inliers. */
class Leverage
{
public:
    //! @param context context in which models are polished and rated
    //! @param polisher polishes the result
    Leverage(const Context& context, Polisher& polisher);

    //! Replaces a polished model with a better model if such a model is found.
    void improve(Model& model);

private:
    enum {
        MOST = 200,  //!< maximum number of inliers in the first fit
        STARTS = 4   //!< number of samples; the best of their models is another start of a fit
    };

    //! A subset of the points.
    struct Points
    {
        int* indices;
        int count;
    };

    //! Finds the inliers of the model, of which at most #MOST are stored in `inliers`. @return
    //! false if there are too few inliers, if all points are inliers, or if the loss of even one
    //! inlier would be evidence against a fit
    bool look(const Model& model);
    //! True if a fit is clearly better than the model for `points`, which agree with the fit, and
    //! if the lost inliers are not evidence against the fit.
    bool convinces(const Model& fitted, const Model& model, const Points& points) const;
    //! Evidence of lost inliers against a fit: minus the natural logarithm of Chernoff's bound (see
    //! SignificantScale) of the probability that `lost` or more of the points that are not inliers
    //! of the fit are inliers of the original model by chance.
    double surpriseOf(int lost) const;
    //! The value of surpriseOf() that the best of all models through two of the n outliers reaches
    //! by chance: 2 log(n).
    double byChance() const;
    //! Finds the elements of `inliers` with the lowest leverage in a fit to `inliers`. @return
    //! false if no inlier has a high leverage or if the leverages cannot be computed
    bool findBulk(const Model& model);
    //! Least squares over `points`, which starts from `model` and from the result of sampled(). The
    //! fit with the lower sum of squared errors is returned in `model`. @return false if both fits
    //! fail
    bool fit(const Points& points, int first, Model& model) const;
    //! Computes the models of #STARTS samples of the points and finds the best of these models.
    //! @param first number of the first of these samples, which selects the random numbers
    bool sampled(const Points& points, int first, Model& model) const;
    //! Finds the points that agree with `model`, which is a fit to `fitted`, and whose leverage in
    //! this fit is at most `most`. @return false if there are too few such points or if the
    //! leverages cannot be computed
    bool agreeing(const Model& model, const Points& fitted, double most, Points& result) const;
    //! Computes the leverages of `points` in a fit to `fitted`.
    template <int ENTRIES>
    bool leveragesOf(const Model& model, const Points& fitted, const Points& points,
                     double* result) const;
    bool leverages(const Model& model, const Points& fitted, const Points& points,
                   double* result) const;
    //! Sum of the squared errors of the points, each capped at the squared threshold.
    double sumOf(const Points& points, const Model& model) const;
    //! Estimates the noise variance from a fit to `count` points whose sumOf() is `sum`.
    double variance(double sum, int count) const;
    //! Number of inliers of `model` among all points.
    int inliersOf(const Model& model) const;

    const Context& context;
    const Components& parts;
    Polisher& polisher;
    const double limit;  //!< squared threshold
    float* errors;       //!< squared errors; memory for all points
    int looked;          //!< only the first `looked` points are used in fits
    Points inliers;      //!< at most MOST inliers among the first `looked` points
    Points bulk;         //!< the elements of `inliers` with low leverage
    int all;             //!< number of inliers of the model among all points
};

}  // namespace usacv20
}  // namespace cv

#endif
