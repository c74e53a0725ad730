// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/fundamental/plane_parallax.hpp"
#include "support/problem_objects.hpp"

namespace opencv_test {
namespace {

const double THRESHOLD = 1.5;

Params paramsOf(const Params& preset)
{
    Params params = preset;
    params.threshold = THRESHOLD;
    params.maxIterations = 20000;
    return params;
}

//! Sum over all matches of the squared ratio of the error to the threshold, where each term is at
//! most 1.
double costOf(const Scene& scene, const cv::Matx33d& F)
{
    double cost = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        const double error = pixelError(scene, F, scene.points1[i], scene.points2[i]) / THRESHOLD;
        cost += std::min(error * error, 1.);
    }
    return cost;
}

SceneOptions planarScene(int size, double plane, double inliers, uint64 seed,
                         Motion motion = MOTION_GENERAL)
{
    SceneOptions options;
    options.setSize(size, inliers);
    options.planeFraction = plane;
    options.seed = seed;
    options.motion = motion;
    return options;
}

//! A scene, its points in the estimator's coordinates, the homography fitted to the true matches on
//! the plane, the indices of all other points (true and wrong), and the refined true model.
struct Parallax
{
    explicit Parallax(const SceneOptions& options)
        : scene(makeScene(FUNDAMENTAL, options)), params(paramsOf(Params())),
          usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena)
    {
        const Correspondences& p = usac->points();
        std::vector<int> on, right;
        for (int i = 0; i < p.size; ++i)
        {
            if (scene.onPlane[p.inputIndex[i]])
                on.push_back(i);
            else
                off.push_back(i);
            if (scene.truth[p.inputIndex[i]])
                right.push_back(i);
        }
        std::vector<cv::Point2d> plane1, plane2;
        for (size_t k = 0; k < on.size(); ++k)
        {
            plane1.push_back(cv::Point2d(p.exact[X1][on[k]], p.exact[Y1][on[k]]));
            plane2.push_back(cv::Point2d(p.exact[X2][on[k]], p.exact[Y2][on[k]]));
        }
        H = cv::Matx33d((const double*)cv::findHomography(plane1, plane2, 0).ptr());
        truth = toInternal(p, scene.model);
        createLeastSquaresSolver(FUNDAMENTAL, Formula::SAMPSON)
            ->fit(p, right.data(), (int)right.size(), 0, truth, 20);
    }

    //! The model with which a search begins: [e]x H with the homography H of the plane and a wrong
    //! epipole e.
    Model wrong() const { return crossMatrix(cv::Vec3d(0.3, -0.2, 1)) * H; }
    //! Prepares a search that begins with wrong().
    void begin(PlaneParallax& parallax, Model& model, Quality& quality) const
    {
        model = wrong();
        quality = context.rate(model);
        parallax.setPlane(context, off.data(), (int)off.size(), H);
    }
    cv::Matx33d toPixels(const Model& F) const { return toInput(usac->points(), F); }

    Scene scene;
    Params params;
    Ptr<Usac> usac;
    Arena arena;
    Context context;
    std::vector<int> off;
    cv::Matx33d H;
    Model truth;
};

//! Number of runs that fail, that is, return no model or a model whose cost exceeds that of the
//! refined true model by more than 1, the cost of one outlier.
int searchFailures(const Params& preset, int size, double plane, double inliers, int scenes)
{
    int failures = 0;
    for (int i = 0; i < scenes; ++i)
    {
        const Parallax p(planarScene(size, plane, inliers, 500 + i));
        Params params = paramsOf(preset);
        params.seed = i;
        const Mat F = estimate(p.scene, params);
        failures += F.empty() || costOf(p.scene, cv::Matx33d(F.ptr<double>())) >
                                     costOf(p.scene, p.toPixels(p.truth)) + 1;
    }
    return failures;
}

//! A plane dominates the scenes. Each row of `cells` contains the fraction of the true matches that
//! are on the plane, and the inlier ratio. In each call of searchFailures(), at most one run (with
//! fast() two) is allowed to fail. For comparison: if the epipole came from 300 random pairs among
//! at most 208 of the points off the plane, 0, 2, 2, 7, 15, 28 and 8 % of the runs would fail in
//! the seven rows.
TEST(Usac_PlaneParallax, fewSearchFailures)
{
    const double cells[][2] = {{0.6, 0.5},  {0.8, 0.5},  {0.9, 0.7}, {0.95, 0.9},
                               {0.95, 0.7}, {0.95, 0.5}, {0.98, 0.7}};
    for (int k = 0; k < 7; ++k)
        EXPECT_LE(searchFailures(Params(), 500, cells[k][0], cells[k][1], 60), 1)
            << cells[k][0] << " " << cells[k][1];
    EXPECT_LE(searchFailures(Params(), 500, 0.95, 0.3, 10), 1);
    EXPECT_LE(searchFailures(Params::accurate(), 500, 0.95, 0.7, 40), 1);
    EXPECT_LE(searchFailures(Params::fast(), 500, 0.95, 0.7, 40), 2);
}

//! Depending on the motion, the epipole is in the image, far away or at infinity. For each motion,
//! the search must find it in at least 39 of 40 scenes.
TEST(Usac_PlaneParallax, allMotions)
{
    const Motion motions[] = {MOTION_GENERAL, MOTION_FORWARD, MOTION_SIDEWAYS, MOTION_RECTIFIED,
                              MOTION_CAR};
    const int SCENES = 40;
    for (int m = 0; m < 5; ++m)
    {
        int found = 0;
        for (int i = 0; i < SCENES; ++i)
        {
            const Parallax p(planarScene(500, 0.9, 0.6, 20 + i, motions[m]));
            Model model;
            Quality quality;
            PlaneParallax parallax;
            p.begin(parallax, model, quality);
            EXPECT_EQ((int)p.off.size(), parallax.size());
            EXPECT_TRUE(parallax.search(p.context, 0.01, 0, model, quality));
            EXPECT_NEAR(1, cv::norm(Matx33d(model)), 1e-9);
            EXPECT_EQ(p.context.rate(model).cost, quality.cost);
            // not all seven parameters are optimized, so the cost is a little above the minimum
            found += quality.cost <= p.context.rate(p.truth).cost + 5;
        }
        EXPECT_GE(found, SCENES - 1) << "motion " << m;
    }
}

//! Only outliers are off the plane. For a correct match off the plane, the epipole is on the
//! line through x2 and H x1 in image 2, where H is the homography of the plane. The search must try
//! this line of each match at most once.
TEST(Usac_PlaneParallax, boundedWhereNothingIsOffThePlane)
{
    const int sizes[] = {20, 200, 1000, 6000};
    for (int k = 0; k < 4; ++k)
    {
        const Parallax p(planarScene(sizes[k], 1, 0.5, 3));
        Model model;
        Quality quality;
        PlaneParallax parallax;
        p.begin(parallax, model, quality);
        parallax.search(p.context, 0.01, 0, model, quality);
        const int lines = parallax.lines();
        EXPECT_LE(lines, std::min<int>(sizes[k] / 2, PlaneParallax::MAX_POINTS));
        EXPECT_LE(lines, 450)
            << "a wrong epipole agrees with about 2 % of the points by chance, so that this limit "
               "holds for any number of points";
        EXPECT_LE(parallax.fits(), lines);
        // a second search must find nothing and must try no further line
        EXPECT_FALSE(parallax.search(p.context, 0.01, 0, model, quality));
        EXPECT_EQ(lines, parallax.lines());
    }
}

//! If at least 100 inliers off the plane are required, few lines must suffice to reject all
//! epipoles.
TEST(Usac_PlaneParallax, wantedInliersShortenTheSearch)
{
    const Parallax p(planarScene(1000, 0.95, 0.5, 4));
    Model model;
    Quality quality;
    PlaneParallax parallax;
    p.begin(parallax, model, quality);
    parallax.search(p.context, 0.01, 100, model, quality);
    EXPECT_LE(parallax.lines(), 60);
    EXPECT_GE(parallax.lines(), 40);
    EXPECT_EQ(0, parallax.fits()) << "only 25 true matches are off the plane";
    EXPECT_TRUE(parallax.search(p.context, 0.01, 0, model, quality))
        << "the search continues where the first search ended";
    EXPECT_GT(parallax.lines(), 60);
    EXPECT_LE(quality.cost, p.context.rate(p.truth).cost + 5);
}

//! Number of epipoles whose fit continues after two steps (PlaneParallax::fits()) if 200 matches
//! share the point `common` of image 2 and only these matches vote. Their points in image 1 are
//! random, and so are both points of 600 other matches.
int fitsOfSharingMatches(const cv::Point2d& common)
{
    const int SHARING = 200;
    RNG rng(1);
    std::vector<cv::Point2d> from(4 * SHARING), to(4 * SHARING, common);
    for (size_t i = 0; i < from.size(); ++i)
    {
        from[i] = uniformPoint(rng, 0., 640., 0., 480.);
        if (i >= SHARING)
            to[i] = uniformPoint(rng, 0., 640., 0., 480.);
    }
    Params params;
    params.threshold = 0.5;
    const Ptr<Usac> usac = Usac::create(FUNDAMENTAL, from, to, params);
    Arena arena;
    const Context context(usac->points(), usac->components(), params, arena);
    std::vector<int> sharing;
    for (int i = 0; i < usac->points().size; ++i)
        if (usac->points().inputIndex[i] < SHARING)
            sharing.push_back(i);
    PlaneParallax parallax;
    parallax.setPlane(context, sharing.data(), SHARING, cv::Matx33d::eye());
    Model model = crossMatrix(cv::Vec3d(0.3, -0.2, 1));
    Quality quality = context.rate(model);
    parallax.search(context, 1e-300, SHARING / 4, model, quality);
    EXPECT_EQ(SHARING, parallax.lines());
    return parallax.fits();
}

//! If matches share a point of image 2, an epipole at this point agrees with them whatever their
//! points in image 1 are. The search must not fit this epipole: on the line of a match, which is
//! divided into bins, the bins near the match's point in image 2 do not count. A projective line is
//! closed, so that its last bin is next to its first one. For many lines, the point where these two
//! bins meet is near (500, 240).
TEST(Usac_PlaneParallax, epipoleAtASharedPoint)
{
    for (int x = 480; x <= 520; x += 4)
        EXPECT_EQ(0, fitsOfSharingMatches(cv::Point2d(x, 240))) << x;
}

//! With no point or a single one off the plane, the search must find nothing and leave the model as
//! it is.
TEST(Usac_PlaneParallax, fewPoints)
{
    const Parallax p(planarScene(100, 1, 1, 6));
    PlaneParallax parallax;
    for (int count = 0; count < 2; ++count)
    {
        Model model = p.wrong();
        const Quality before = p.context.rate(model);
        Quality quality = before;
        const int off = 7;
        parallax.setPlane(p.context, &off, count, p.H);
        EXPECT_FALSE(parallax.search(p.context, 0.01, 0, model, quality));
        EXPECT_EQ(p.wrong(), model);
        EXPECT_EQ(before.cost, quality.cost);
    }
}

}  // namespace
}  // namespace opencv_test
