// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESTARTS_HPP
#define OPENCV_USACV20_RESTARTS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Fits to the inliers of a polished model from other starts, where they are few or the
threshold is wide.

The sum of squared errors has local minima. A search that has rated thousands of models has met the
best of them, but not one that ends with its first sample: ten points whose errors are all below the
threshold, whatever the model is. The checks of orientation make it worse where they do not hold, as
for an H whose horizon lies between the points: they refuse all samples but those on one side of it,
and these may all lead to one wrong minimum.

Least squares over the inliers (at most #MOST) starts from the models of random samples of them, of
which none is refused. A minimum that is clearly lower is polished and takes the place of the model,
if it costs no more; one that the checks would not have let pass has to be lower by far, as there
are more such models.

Few inliers that are near each other determine the model badly far from them. So the next points
outside are tried, too: the fit to the inliers and one of them replaces the model if all are inliers
of it, with errors that are hardly larger.
*/
class Restarts
{
public:
    /** @param search of the search: its points, solver and checks
    @param polish what models are polished with and rated by; its points are those of `search`,
    maybe as they were seen
    @param state of the run */
    Restarts(const Context& search, const Context& polish, State& state);

    //! Replaces a polished model by a better one. @param quality of the model in `polish`
    void improve(Model& model, Quality& quality);

    /** The checks have refused each sample of a few points: finds a model that fits all of them
    better than random ones would, if there is one. @return false: there is none */
    bool begin(Model& model, Quality& quality);

private:
    enum {
        //! Inliers: most that take part; with more there are no restarts, unless the threshold is
        //! wide. Half: failures 2 -> 6 of 8400 scenes; double: the same.
        MOST = 30,
        //! Points outside that are tried, and steps of a fit. Half, double: the same.
        NEXT = 4,
        STEPS = 20
    };

    //! Finds the inliers, and the points outside that come next. @return false if there is nothing
    //! to do
    bool look(const Model& model);
    //! From samples of the inliers, and from the model itself.
    void restartInliers(Model& model, Quality& quality);
    //! From samples with one of few points outside.
    void restartOutside(Model& model, Quality& quality);
    //! With one of the points outside, from the model.
    void extendInliers(Model& model, Quality& quality);
    //! Least squares over the first members from the models of a sample of them, which has the last
    //! one if that is no inlier. @return true if it is better
    bool restart(int index, int size, Model& model, Quality& quality);
    //! What the checks say of a sample and its model.
    bool isValid(const int* sample, const Model& model) const;
    //! Least squares over the inliers and one of the points outside.
    bool extend(int outside, Model& model, Quality& quality);
    //! Numbers that the errors of so many points have more than the model.
    int freedom(int size) const;
    //! Squared errors of the first members in squared thresholds, at most 1 each.
    double lossOf(const Model& model, int size) const;
    bool fit(int size, Model& model) const;
    //! Takes a fit if its loss, after polishing, is below a limit, and if it costs no more.
    bool accept(const Model& fitted, int size, double limit, Model& model, Quality& quality);
    //! Quality after the checks; false if they drop the model.
    bool check(Model& model, Quality& quality);

    const Context& search;
    const Context& context;
    const Components& parts;
    State& state;
    const int m;            //!< points of a sample
    int members[MOST + 1];  //!< inliers, and room for another point
    int next[NEXT];         //!< points outside, nearest first
    int count, all;         //!< members, and inliers
    int outside;            //!< of those in `next`
    double loss;            //!< of the model
};

}  // namespace usacv20
}  // namespace cv

#endif
