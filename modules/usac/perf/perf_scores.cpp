// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_precomp.hpp"
#include "perf_scene.hpp"

namespace opencv_test {
namespace {

//! How a model is rated. FUSED: with a kernel that fuses residual and score; NOT_FUSED: with the
//! residual, and then with the score; EARLY_EXIT: with the fused kernel, but for a wrong model,
//! whose rating ends early when its cost exceeds that of the true model.
enum Way { FUSED, NOT_FUSED, EARLY_EXIT };

enum { TRANSFER, SAMPSON };

CV_ENUM(ResidualKind, TRANSFER, SAMPSON)
CV_ENUM(ScoreKind, QUALITY_INLIERS, QUALITY_MSAC)
CV_ENUM(RatingWay, FUSED, NOT_FUSED, EARLY_EXIT)
typedef TestBaseWithParam<tuple<ResidualKind, ScoreKind, RatingWay, int>> UsacScore;

//! A residual for which no score has a fused kernel.
class UnknownResidual : public Residual
{
public:
    explicit UnknownResidual(const Ptr<Residual>& known_) : known(known_) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        known->squaredErrors(points, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        known->squaredErrors(model, columns, count, errors);
    }

private:
    const Ptr<Residual> known;
};

//! One test cycle rates a model as often as necessary for 1000000 points in total, so that a
//! millisecond per cycle is a nanosecond per point. (With EARLY_EXIT, not all points are tested.)
PERF_TEST_P(UsacScore, rate_1000000points,
            testing::Combine(ResidualKind::all(), ScoreKind::all(), RatingWay::all(),
                             testing::Values(100, 1000, 10000, 100000)))
{
    const ProblemType problem = get<0>(GetParam()) == TRANSFER ? HOMOGRAPHY : FUNDAMENTAL;
    const int way = get<2>(GetParam()), size = get<3>(GetParam()), models = 1000000 / size;
    Params params;
    params.quality = (QualityType)(int)get<1>(GetParam());
    const PerfScene scene(problem, size, params);
    Ptr<Residual>& residual = scene.usac->components().residual;
    if (way == NOT_FUSED)
        residual = makePtr<UnknownResidual>(residual);
    const Context& context = scene.context;
    const Quality right = context.rate(scene.model);
    const Model wrong = Matx33d(scene.model) + Matx33d::eye() * 0.5;
    Quality sum;
    TEST_CYCLE()
    {
        sum = Quality(0, 0);
        for (int k = 0; k < models; ++k)
        {
            const Quality quality = way == EARLY_EXIT ? context.rate(wrong, right.cost)
                                                      : context.rate(scene.model);
            sum.cost += quality.cost;
            sum.inliers += quality.inliers;
        }
    }
    if (way == EARLY_EXIT)
        EXPECT_GE(sum.cost, right.cost * models);
    else
        EXPECT_EQ(right.inliers * models, sum.inliers);
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
