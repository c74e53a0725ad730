// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MARGINALIZED_FIT_HPP
#define OPENCV_USACV20_MARGINALIZED_FIT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief One iteration of re-weighted least squares with the weights of MAGSAC++
@cite barath2020magsac: weigh(), then fit().

The weights are the derivative of a loss with respect to the squared error. As they decrease with
the error, a fit to all weighted points never increases this loss. */
class MarginalizedFit
{
public:
    MarginalizedFit() : errors(0), indices(0), weights(0), count(0) {}

    //! Takes memory for `points` points. To be called before the other methods.
    void allocate(Arena::Scope& scope, int points)
    {
        errors = scope.take<float>(points);
        indices = scope.take<int>(points);
        weights = scope.take<double>(points);
        count = 0;
    }
    //! Computes the weights of the points whose errors under the model are within the threshold.
    //! @return the sum of the losses of all points
    double weigh(const Context& context, double threshold, const Model& model);
    //! Number of weighted points.
    int size() const { return count; }
    //! Keeps a random subset of `most` weighted points, or all weighted points if there are fewer.
    void reduce(int most, Rng& rng);
    //! Fits `model` to the weighted points, starting from its present value. @return false if there
    //! are too few points or if they do not determine a model
    bool fit(const Context& context, Model& model) const;

private:
    float* errors;
    int* indices;
    double* weights;
    int count;  //!< number of weighted points
};

}  // namespace usacv20
}  // namespace cv

#endif
