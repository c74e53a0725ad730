// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LEVERAGE_HPP
#define OPENCV_USACV20_LEVERAGE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Corrects a polished model that is distorted by a few wrong matches of high leverage.

If the right matches leave some parameters of a model nearly free (the epipole of F for a short
baseline), the model can be distorted to fit wrong matches as well: the errors of the right matches
grow, but stay far below a threshold that is wide for the noise. Such a model costs less than the
true one, by the loss of any score or polisher and by the likelihood of the true noise, so no search
can prefer the true model by its cost. But the wrong matches alone determine these parameters.
Therefore they have a high leverage (the part of its own error that a point removes from a fit), and
without them, the other inliers have another optimum with clearly lower errors.

So the inliers with the highest leverage are left out. Fits to the others start from the model and
from samples of these others. Points that agree with the fit are taken back, at first only those of
low leverage, as in a forward search @cite atkinson2000robust. A fit to all points taken back is
polished. It replaces the model on two conditions: the errors of those of these points that are
inliers of the model are lower by more than chance explains; and the lost inliers are no evidence
against the fit, that is, the best of all models through two wrong matches would have as many by
chance, and losing them is less improbable than the decrease of the errors. (Right matches off a
plane have a high leverage, too. But they are more than the matches that agree with one epipole by
chance, and if most inliers are on a plane, the errors have to decrease more; E is then not
changed.)

Only for errors with one component: with more, a wrong match is rarely within the threshold by
chance. At most #MOST inliers are used, which bounds the time, except that of polishing. */
class Leverage
{
public:
    /** @param search context of the search: its points, solver and checks
    @param polish context in which models are polished and rated
    @param threshold inlier threshold of the mask, in the coordinates of `polish` */
    Leverage(const Context& search, const Context& polish, double threshold);

    //! Replaces a polished model by a better one, if any. @param quality its quality in `polish`
    void improve(Model& model, Quality& quality);

private:
    //! Effects of halving or doubling each: doc/constants.md.
    enum {
        MOST = 200,  //!< maximum number of inliers that are used
        STARTS = 4   //!< number of samples whose best model is another start of a fit
    };

    //! A subset of the points.
    struct Points
    {
        int* indices;
        int count;
    };

    //! Finds the inliers that are used. @return false if there is nothing to do
    bool look(const Model& model);
    //! Is a fit better than the model for the points that agree with the fit, and are the lost
    //! inliers no evidence against the fit?
    bool convinces(const Model& fitted, const Model& model, const Points& points) const;
    //! Minus the logarithm of Chernoff's bound (see SignificantScale) of the probability that
    //! `lost` of the points that are not inliers of a fit are inliers of the model by chance.
    double surpriseOf(int lost) const;
    //! Value of surpriseOf() that the best of all models through two outliers has by chance.
    double byChance() const;
    //! Finds the inliers with the lowest leverage in a fit to all inliers. @return false if no
    //! inlier has a high leverage
    bool findBulk(const Model& model);
    //! Least squares over some points, from the model and from the result of sampled().
    bool fit(const Points& points, int first, Model& model) const;
    //! The best model of #STARTS samples of the points. @param first number of the first sample
    bool sampled(const Points& points, int first, Model& model) const;
    //! Finds the points that agree with `model`, which is a fit to `fitted`, and whose leverage in
    //! this fit is at most `most`.
    bool agreeing(const Model& model, const Points& fitted, double most, Points& result) const;
    //! Leverages of points in a fit to `fitted`.
    template <int ENTRIES>
    bool leveragesOf(const Model& model, const Points& fitted, const Points& points,
                     double* result) const;
    bool leverages(const Model& model, const Points& fitted, const Points& points,
                   double* result) const;
    //! Sum of the squared errors of the points, each capped at the squared threshold.
    double sumOf(const Points& points, const Model& model) const;
    //! Noise variance, if sumOf() is `sum` for a fit to `count` points.
    double variance(double sum, int count) const;
    //! Number of inliers among all points.
    int inliersOf(const Model& model) const;

    const Context& search;
    const Context& context;
    const Components& parts;
    const double limit;  //!< squared threshold
    float* errors;       //!< room for all points
    int looked;          //!< only the first `looked` points are used
    Points inliers;      //!< inliers among these points
    Points bulk;         //!< those of `inliers` with low leverage
    int all;             //!< number of inliers among all points
};

}  // namespace usacv20
}  // namespace cv

#endif
