// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/linear_map.hpp"
#include "support/contracts.hpp"

// Tests of affinities and similarities of every kind, and of points that determine a map only
// roughly or not at all. For comparison, a map is fitted by least squares to the true matches.

namespace opencv_test {
namespace {

typedef UsacProblem Usac_Maps;
INSTANTIATE_TEST_CASE_P(/**/, Usac_Maps, testing::Values((int)AFFINITY, (int)SIMILARITY));

struct KindOfMap
{
    const char* name;
    Matx23d map;
    bool similar;
};

const KindOfMap KINDS[] = {{"identity", Matx23d(1, 0, 0, 0, 1, 0), true},
                           {"translation", Matx23d(1, 0, 37, 0, 1, -12), true},
                           {"half turn", Matx23d(-1, 0, 640, 0, -1, 480), true},
                           {"quarter turn", Matx23d(0, -1, 480, 1, 0, 0), true},
                           {"scale 1000", Matx23d(1000, 0, -3, 0, 1000, 9), true},
                           {"scale 1/1000", Matx23d(0.0008, 0.0006, 2, -0.0006, 0.0008, 1), true},
                           {"far away", Matx23d(0.8, 0.6, 1e6, -0.6, 0.8, -1e6), true},
                           {"reflection", Matx23d(-1, 0, 640, 0, 1, 0), false},
                           {"transposition", Matx23d(0, 1, 0, 1, 0, 0), false},
                           {"shear", Matx23d(1, 0.7, 0, 0, 1, 0), false},
                           {"one side 100 times the other", Matx23d(10, 0, 0, 0, 0.1, 3), false}};
const int KIND_COUNT = sizeof(KINDS) / sizeof(KINDS[0]);

Point2d mapped(const Matx23d& map, const Point2d& p)
{
    const Vec2d q = map * Vec3d(p.x, p.y, 1);
    return Point2d(q[0], q[1]);
}

//! Matches of a map with noise in image 2, followed by random wrong matches. All points of image 1
//! are in a box of 640 x 480; the wrong points of image 2 are in the area to which this box is
//! mapped.
struct Matches
{
    Matches(const Matx23d& map_, int right_, int wrong, double noise_, uint64 seed)
        : map(map_), right(right_)
    {
        RNG rng(seed);
        // mean scale of the map; noise and threshold are multiples of it
        unit = std::sqrt(std::abs(map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0)));
        for (int i = 0; i < right + wrong; ++i)
        {
            const Point2d p = uniformPoint(rng, 0., 640., 0., 480.),
                          q = uniformPoint(rng, 0., 640., 0., 480.),
                          error = gaussianPoint(rng, noise_ * unit);
            points1.push_back(p);
            points2.push_back(i < right ? mapped(map, p) + error : mapped(map, q));
        }
    }

    //! Root mean square distance, over the true matches, between points mapped by `model` and by
    //! the true map, divided by `unit`. Infinite without a map.
    double error(const Mat& model) const
    {
        if (model.empty())
            return std::numeric_limits<double>::infinity();
        double sum = 0;
        for (int i = 0; i < right; ++i)
            sum += std::pow(cv::norm(mapped(Matx23d(model.ptr<double>()), points1[i]) -
                                     mapped(map, points1[i])),
                            2);
        return std::sqrt(sum / right) / unit;
    }

    double errorOfLeastSquares(ProblemType problem) const
    {
        const Matx23d best = linearMap(
            problem, std::vector<Point2d>(points1.begin(), points1.begin() + right),
            std::vector<Point2d>(points2.begin(), points2.begin() + right));
        return error(Mat(best));
    }

    //! Estimates a map and checks the documented properties of the result.
    Mat estimate(ProblemType problem, Params params) const
    {
        params.threshold *= unit;
        Mat mask;
        Report report;
        const Mat model = estimatePoints(problem, points1, points2, params, mask, report);
        checkResult(problem, points1, points2, params.threshold, model, mask, report);
        return model;
    }

    const Matx23d map;
    const int right;
    double unit;  //!< mean scale of the map
    std::vector<Point2d> points1, points2;
};

TEST_P(Usac_Maps, kinds)
{
    for (int k = 0; k < KIND_COUNT; ++k)
    {
        SCOPED_TRACE(KINDS[k].name);
        double ours = 0, best = 0;
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            const Matches matches(KINDS[k].map, 100, 60, 0.5, seed);
            Params params;
            params.threshold = 2;
            const Mat model = matches.estimate(problem(), params);
            // no similarity fits, so that only the checks of estimate() apply
            if (problem() == SIMILARITY && !KINDS[k].similar)
                continue;
            ours += matches.error(model);
            best += matches.errorOfLeastSquares(problem());
        }
        EXPECT_LE(ours, 1.1 * best);
    }
}

TEST_P(Usac_Maps, inlierRatios)
{
    const int ratios[] = {5, 10, 20, 30, 50, 70, 90};
    for (int r = 0; r < 7; ++r)
    {
        double ours = 0, best = 0;
        for (uint64 seed = 1; seed <= 10; ++seed)
        {
            const int right = 400 * ratios[r] / 100;
            const Matches matches(Matx23d(0.8, 0.6, 10, -0.6, 0.8, 300), right, 400 - right, 0.5,
                                  seed);
            Params params;
            params.threshold = 2;
            params.maxIterations = 100000;
            ours += matches.error(matches.estimate(problem(), params));
            best += matches.errorOfLeastSquares(problem());
        }
        EXPECT_LE(ours, 1.15 * best) << ratios[r] << " % are right";
    }
}

TEST_P(Usac_Maps, pointsOfALine)
{
    RNG rng(3);
    std::vector<Point2d> line, places;
    const Matx23d map(0.8, 0.6, 10, -0.6, 0.8, 300);
    for (int i = 0; i < 80; ++i)
    {
        line.push_back(Point2d(i, 40 + 3 * i));
        places.push_back(mapped(map, line[i]));
    }
    Report report;
    const Mat exact = estimatePoints(problem(), line, places, Params(), noArray(), report);
    EXPECT_EQ(problem() == AFFINITY, exact.empty());
    const std::vector<Point2d> same(80, Point2d(3, 4));
    EXPECT_TRUE(estimatePoints(problem(), same, places, Params(), noArray(), report).empty());
    EXPECT_TRUE(estimatePoints(problem(), line, same, Params(), noArray(), report).empty());
    EXPECT_TRUE(estimatePoints(problem(), same, same, Params(), noArray(), report).empty());
    // Points nearly on a line hardly determine what an affinity does off the line. The sum of
    // squared errors at the points must be at most 1.1 times that of least squares.
    for (double width = 2; width > 1e-3; width /= 10)
    {
        std::vector<Point2d> points1 = line, points2;
        for (int i = 0; i < 80; ++i)
        {
            points1[i].x += rng.uniform(-width, width);
            points2.push_back(mapped(map, points1[i]) + gaussianPoint(rng, 0.3));
        }
        const Mat model = estimatePoints(problem(), points1, points2, Params(), noArray(), report);
        ASSERT_FALSE(model.empty()) << width;
        const Matx23d best = linearMap(problem(), points1, points2), found(model.ptr<double>());
        double ours = 0, theirs = 0;
        for (int i = 0; i < 80; ++i)
        {
            ours += std::pow(cv::norm(mapped(found, points1[i]) - points2[i]), 2);
            theirs += std::pow(cv::norm(mapped(best, points1[i]) - points2[i]), 2);
        }
        EXPECT_LE(ours, 1.1 * theirs) << width;
    }
}

}
}  // namespace
