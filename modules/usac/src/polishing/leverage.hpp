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
baseline), the model can be distorted to fit wrong matches as well: the errors of the right ones
grow, but stay far below a threshold that is wide for the noise. Such a model costs less than the
true one, by the loss of any score or polisher and by the likelihood of the true noise, so no search
can prefer the true one by its cost. But the wrong matches alone determine these parameters, so they
have a high leverage, which is the part of its own error that a point removes from a fit; and
without them, the other inliers have another optimum with clearly lower errors.

The inliers with the highest leverage are therefore left out. The others are fitted, from the model
and from samples of them, and points that agree with their prediction by this fit are taken back,
first those that it predicts well, as in a forward search @cite atkinson2000robust. The result is
polished. It replaces the model if the errors of the points that were taken back and were inliers of
the model are lower by more than chance explains, and if the lost inliers are no evidence against
it: the best of all models through two wrong matches would have as many by chance, and losing them
is less improbable than the decrease of the errors. (Right matches off a plane have a high leverage,
too. But they are more than those by chance at one epipole, and if most inliers are on a plane, the
errors have to decrease more; E is not changed there.)

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
    //! Halving and doubling these: doc/constants.md.
    enum {
        MOST = 200,  //!< maximum number of inliers that are used
        STARTS = 4   //!< samples from which fits start
    };

    //! A subset of the points.
    struct Points
    {
        int* indices;
        int count;
    };

    //! Finds the inliers that are used. @return false if there is nothing to do
    bool look(const Model& model);
    //! Is a fit better than the model for the points that agree with it, and are the inliers lost
    //! no evidence against it?
    bool convinces(const Model& fitted, const Model& model, const Points& points) const;
    //! Minus the logarithm of Chernoff's bound (see SignificantScale) of the probability that
    //! `lost` of the points that are not inliers of a fit are inliers of the model by chance.
    double surpriseOf(int lost) const;
    //! Value of surpriseOf() that the best of all models through two of these points has by chance.
    double byChance() const;
    //! Finds the inliers with the lowest leverage in a fit to all. @return false if none is high
    bool findBulk(const Model& model);
    //! Least squares over some points, from the model and from samples of them.
    bool fit(const Points& points, int first, Model& model) const;
    //! The best model of some samples of the points.
    bool sampled(const Points& points, int first, Model& model) const;
    //! Finds the points that agree with `model`, a fit to `fitted`, and have a leverage of at most
    //! `most` in it.
    bool agreeing(const Model& model, const Points& fitted, double most, Points& result) const;
    //! Leverages of points in a fit to `fitted`.
    template <int ENTRIES>
    bool leveragesOf(const Model& model, const Points& fitted, const Points& points,
                     double* result) const;
    bool leverages(const Model& model, const Points& fitted, const Points& points,
                   double* result) const;
    //! Sum of the squared errors of the points, each at most the squared threshold.
    double sumOf(const Points& points, const Model& model) const;
    //! Noise variance from such a sum of a fit to `count` points.
    double variance(double sum, int count) const;
    //! Number of inliers among all points.
    int inliersOf(const Model& model) const;

    const Context& search;
    const Context& context;
    const Components& parts;
    const double limit;  //!< squared threshold
    float* errors;       //!< room for all points
    int looked;          //!< number of points that are used, the first ones
    Points inliers;      //!< inliers among these points
    Points bulk;         //!< those of `inliers` with low leverage
    int all;             //!< number of inliers among all points
};

}  // namespace usacv20
}  // namespace cv

#endif
