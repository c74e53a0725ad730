// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/scores.hpp"
#include "scoring/marginalized_weights.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** MAGSAC++ @cite barath2020magsac: the cost of a point is the robust loss that belongs to weights
marginalized over the scale of the noise, see MarginalizedWeights. The cost takes a table lookup for
each point within the threshold. */
class MagsacPlusPlusScore : public Score
{
public:
    MagsacPlusPlusScore(int errorDimension, double reach)
        : table(MarginalizedWeights::of(errorDimension)), part(1 / reach)
    {}

    double inlierPart() const CV_OVERRIDE { return part; }

    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        const int near = keepInliers(squaredErrors, count, squaredThreshold);
        const float factor = 1 / squaredThreshold;
        for (int i = 0; i < near; ++i)
            squaredErrors[i] *= factor;
        sum.inliers += countWithin(squaredErrors, near, (float)(part * part));
        sum.cost += count - near + table.sumOfLosses(squaredErrors, near);
    }

private:
    const MarginalizedWeights& table;
    const double part;
};

}  // namespace

Ptr<Score> createMagsacPlusPlusScore(int errorDimension, double reach)
{
    return makePtr<MagsacPlusPlusScore>(errorDimension, reach);
}

}  // namespace usacv20
}  // namespace cv
