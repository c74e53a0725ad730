// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SCORES_HPP
#define OPENCV_USACV20_SCORES_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** Number of inliers @cite fischler1981random. The cost of a point is 0 if its error is within the
threshold, else 1. Errors and score are computed in one pass over the points (Score::fused). */
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
//! See MagsacScore. @param errorDimension Problem::errorDimension
//! @param reach Params::reach: inliers are the points with errors of at most the threshold of the
//! search divided by `reach`
Ptr<Score> createMagsacScore(int errorDimension, double reach);
//! See MagsacPlusPlusScore. @param errorDimension, reach as above
Ptr<Score> createMagsacPlusPlusScore(int errorDimension, double reach);

//! See LogarithmicScore.
Ptr<Score> createLogarithmicScore();

//! Result of the evaluation of one model.
struct Rating
{
    Quality quality;    //!< score of the blocks evaluated so far; of all points if `complete`
    bool complete;      //!< false: rejected by the verifier, or not better than the bound
    bool refused;       //!< true: rejected by the verifier
    int firstInliers;   //!< number of inliers in the first block
    int firstTested;    //!< number of points in the first block
    double costBefore;  //!< cost before the last evaluated block
};

/** Scores one model block by block and lets the verifier (null: none) test it: lines 10 to 12 of
Algorithm 1 of @cite ivashechkin2021usacv20 in one pass over the points. The evaluation ends early
if the verifier rejects the model after a block, or if the cost of the model reaches `bound`. The
blocks begin at point `start` and wrap around, so that the points tested first are not always the
same. `errors` is temporary memory with one number per point, for scores that need all errors at
once (Score::wholeModel); for other scores it may be null. */
Rating rate(const Context& context, const Verifier* verifier, const Model& model, double bound,
            int start, float* errors);

}  // namespace usacv20
}  // namespace cv

#endif
