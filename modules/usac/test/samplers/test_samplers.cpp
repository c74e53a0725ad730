// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/draw.hpp"
#include "samplers/samplers.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Samplers, asManyPointsAsASampleNeeds)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int kind = 0; kind < 3; ++kind)
            for (int more = 0; more < 3; ++more)
            {
                const int N = sampleSizeOf(problem) + more;
                Draw draw((ProblemType)problem, N,
                          kind == 0   ? createUniformSampler()
                          : kind == 1 ? createProsacSampler()
                                      : createPNapsacSampler());
                for (int i = 0; i < 300; ++i)
                {
                    draw.next();
                    ASSERT_TRUE(draw.valid()) << problem << " " << kind << " " << more;
                }
            }
}

//! An ordering that counts the calls of sort(). The order is informative if `known` is true.
class CountingOrdering : public Ordering
{
public:
    explicit CountingOrdering(bool known_) : calls(0), known(known_) {}
    void sort(const Context&, int*) CV_OVERRIDE { ++calls; }
    bool informative(const Context&) const CV_OVERRIDE { return known; }
    int calls;

private:
    const bool known;
};

int sortings(ProblemType problem, OrderingType ordering, int outliers)
{
    SceneOptions options;
    options.outliers = outliers;
    const Scene scene = makeScene(problem, options);
    Params params;
    params.ordering = ordering;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<CountingOrdering> counting = makePtr<CountingOrdering>(ordering != ORDERING_DENSITY);
    usac->components().ordering = counting;
    EXPECT_FALSE(usac->run().empty());
    return counting->calls;
}

//! Without outliers, the search must end before the order is needed, whether the order is
//! informative or not. With outliers, the points must be sorted once.
TEST(Usac_Samplers, pointsAreSortedOnceAndOnlyIfNeeded)
{
    for (int problem = FUNDAMENTAL; problem <= ESSENTIAL; ++problem)
    {
        EXPECT_EQ(0, sortings((ProblemType)problem, ORDERING_DENSITY, 0)) << problem;
        EXPECT_EQ(1, sortings((ProblemType)problem, ORDERING_DENSITY, 150)) << problem;
        EXPECT_EQ(0, sortings((ProblemType)problem, ORDERING_INPUT_ORDER, 0)) << problem;
        EXPECT_EQ(1, sortings((ProblemType)problem, ORDERING_INPUT_ORDER, 150)) << problem;
    }
}

}
}  // namespace
