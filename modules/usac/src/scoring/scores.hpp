// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SCORES_HPP
#define OPENCV_USACV20_SCORES_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** Number of inliers @cite fischler1981random. The cost of a point is 0 within the threshold,
else 1. One pass over the points, fused with the residual. */
class InlierScore : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE;
    FusedKernel fused(const Residual& residual) const CV_OVERRIDE;
    bool countsInliers() const CV_OVERRIDE { return true; }
};

//! Number of inliers @cite fischler1981random; the cost of a point is 0 or 1.
Ptr<Score> createInlierScore();
//! MSAC @cite torr2000mlesac; the cost of a point is min(error^2 / threshold^2, 1).
Ptr<Score> createMsacScore();
//! See MlesacScore.
Ptr<Score> createMlesacScore();
//! See LmedsScore.
Ptr<Score> createLmedsScore();
//! See MagsacScore. @param reach Params::reach: inliers are the points with an error of at most
//! 1 / reach times the threshold of the cost
Ptr<Score> createMagsacScore(int errorDimension, double reach);
//! See MagsacPlusPlusScore. @param reach as above
Ptr<Score> createMagsacPlusPlusScore(int errorDimension, double reach);

//! See LogarithmicScore.
Ptr<Score> createLogarithmicScore();

//! Result of the evaluation of one model.
struct Rating
{
    Quality quality;    //!< of all points if `complete`
    bool complete;      //!< false: rejected by the verifier, or no better than the bound
    bool refused;       //!< rejected by the verifier
    int firstInliers;   //!< inliers of the first block
    int firstTested;    //!< points of the first block
    double costBefore;  //!< cost before the last evaluated block
};

/** Evaluates one model block by block: lines 11 and 13 of Algorithm 1 in one pass over the points.
The evaluation ends early if the verifier rejects the model after a block, or if its cost reaches
the bound. The blocks start at point `start` and wrap around, so that it is not always the same
points that are tested first. `errors` has room for one number per point, for scores that need all
errors at once (Score::wholeModel); else it may be null. */
Rating rate(const Context& context, const Verifier* verifier, const Model& model, double bound,
            int start, float* errors);

}  // namespace usacv20
}  // namespace cv

#endif
