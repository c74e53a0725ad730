// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LEVERAGE_HPP
#define OPENCV_USACV20_LEVERAGE_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Frees a polished model from wrong matches that it was bent to.

Where the right matches leave some of a model's parameters nearly free (the epipole of F when the
camera has hardly moved), the model can be bent to go through wrong ones as well: the errors of the
right ones grow, but stay far below a threshold that is wide for the noise. That costs less than the
truth, by the losses of all scores and polishers and by the likelihood of the true noise, so no
search finds the truth by its cost. What tells is the leverage of the wrong matches, the part of its
own error that a point takes away from a fit: they hold these parameters alone. And the others,
without them, have another optimum, with clearly lower errors.

So the inliers with the highest leverage are left out. The others are fitted, from the model and
from samples of them, and points that agree with what this fit predicts for them come back, those
first that it predicts well, as in a forward search @cite atkinson2000robust. The result is
polished, and takes the place of the model if the errors of the points that came back and were
inliers of the model are lower by more than chance explains, and if the inliers that are lost are no
evidence against it: no more than the best of the models through two wrong matches meets among all
of them by chance, and less improbable than those errors. (The right matches off a plane have a high
leverage, too; but they are more than chance brings to one epipole, and where a plane has most
inliers, the errors have to be lower by more; E is left alone there.)

For errors with one component: a wrong match is hardly within the threshold of a model by chance if
there are more. At most #MOST inliers are looked at, so the time is bounded; that of the polishing
is not. */
class Leverage
{
public:
    /** @param search of the search: its points, solver and checks
    @param polish what models are polished with and rated by
    @param threshold that of the mask, in the coordinates of `polish` */
    Leverage(const Context& search, const Context& polish, double threshold);

    //! Replaces a polished model by a better one. @param quality of the model in `polish`
    void improve(Model& model, Quality& quality);

private:
    //! Half, double: doc/constants.md.
    enum {
        MOST = 200,  //!< inliers that are looked at
        STARTS = 4   //!< samples that fits start from
    };

    //! Some of the points.
    struct Points
    {
        int* indices;
        int count;
    };

    //! Finds the inliers that are looked at. @return false if there is nothing to do
    bool look(const Model& model);
    //! Is a fit better than the model for the points that agree with it, and are the inliers lost
    //! no evidence against it?
    bool convinces(const Model& fitted, const Model& model, const Points& points) const;
    //! Minus the logarithm of the probability, at most, that so many of the points that are no
    //! inliers, and of themselves, are met by a model by chance (Chernoff's bound, see
    //! SignificantScale).
    double surpriseOf(int lost) const;
    //! What it may be if the best model through two of these points is taken.
    double byChance() const;
    //! Inliers with the lowest leverage under a fit to all. @return false if no leverage is high
    bool findBulk(const Model& model);
    //! Least squares over some points, from the model and from samples of them.
    bool fit(const Points& points, int first, Model& model) const;
    //! The best model of some samples of the points.
    bool sampled(const Points& points, int first, Model& model) const;
    //! The points that agree with a fit to `fitted` and have at most this leverage under it.
    bool agreeing(const Model& model, const Points& fitted, double most, Points& result) const;
    //! Leverages of points under a fit to `fitted`.
    template <int ENTRIES>
    bool leveragesOf(const Model& model, const Points& fitted, const Points& points,
                     double* result) const;
    bool leverages(const Model& model, const Points& fitted, const Points& points,
                   double* result) const;
    //! Squared errors of the points, each at most the squared threshold.
    double sumOf(const Points& points, const Model& model) const;
    //! Variance of the noise from such a sum of a fit to so many points.
    double variance(double sum, int count) const;
    //! Of all points.
    int inliersOf(const Model& model) const;

    const Context& search;
    const Context& context;
    const Components& parts;
    const double limit;  //!< squared threshold
    float* errors;       //!< room for all points
    int looked;          //!< the first so many points are looked at
    Points inliers;      //!< of those
    Points bulk;         //!< of those, with low leverage
    int all;             //!< inliers
};

}  // namespace usacv20
}  // namespace cv

#endif
