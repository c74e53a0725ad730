// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGMA_CONSENSUS_HPP
#define OPENCV_USACV20_SIGMA_CONSENSUS_HPP

#include "components/point_subset.hpp"

namespace cv {
namespace usacv20 {

/** @brief sigma-consensus @cite barath2019magsac: a fit that is marginalized over the noise scale.

The scales are the standard deviations sigma from 0 to sigma_max, which is the threshold divided by
thresholdInSigmas(). This range is divided into #PARTITIONS equal parts. The model of a part is the
least-squares fit to the points whose error under the initial model is below thresholdInSigmas()
times the largest sigma of the part. If there are no more such points than in a minimal sample, if
they are the same as for the previous part, or if the fit fails, the model of the previous part is
used (for the first part, the initial model). The weight of a point is its likelihood under the
model of each scale, marginalized over the scale as in MarginalizedWeights: the contribution of a
part is the weight of MarginalizedWeights for the largest sigma of the part minus the weight for the
smallest one. The result is the fit with these weights.

Only points within the threshold under the initial model are used, or #MAX_FIT random points of
these if there are more. This bounds the time of the fits (one per part and a final one). In
addition, the errors of all points are computed once. */
class SigmaConsensus
{
public:
    /** PARTITIONS: number of parts, as in the program of the paper's authors. MAX_FIT: maximum
    number of points. See doc/constants.md. */
    enum { PARTITIONS = 5, MAX_FIT = 500 };

    explicit SigmaConsensus(int partitions_ = PARTITIONS) : partitions(partitions_), count(0) {}

    //! Replaces the model with the marginalized fit. False if the points do not determine a model.
    bool fit(const Context& context, Rng& rng, Model& model);

    //! Number, indices and weights of the points of positive weight in the last fit, in the order
    //! of ascending error under the initial model.
    int size() const { return count; }
    const int* points() const { return indices; }
    const double* pointWeights() const { return weights; }

private:
    //! A point and its squared error in units of the squared threshold.
    struct Near
    {
        float error;
        int index;
        bool operator<(const Near& other) const
        {
            return error < other.error || (error == other.error && index < other.index);
        }
    };

    //! @param all array for all points, used as temporary memory
    void select(const Context& context, Rng& rng, const Model& model, Near* all);
    //! Adds to the weights the likelihoods of the points under `model`, the model of one part of
    //! the scales. @param part number of this part, counted from 1
    void marginalize(const Context& context, PointSubset& subset, const Model& model, int part);

    const int partitions;
    int count;  //!< number of selected points; after a fit, of those with positive weight
    Near near[MAX_FIT];
    int indices[MAX_FIT];
    double weights[MAX_FIT];
};

}  // namespace usacv20
}  // namespace cv

#endif
