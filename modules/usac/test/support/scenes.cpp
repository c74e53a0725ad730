// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/scene_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "opencv2/usac/geometry.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

namespace {

//! Smallest and largest displacement in pixels for OUTLIERS_LOCAL.
const double MIN_SHIFT = 5, MAX_SHIFT = 50;
//! Approximate mean number of wrong matches that share a point for OUTLIERS_MANY_TO_ONE.
const int MATCHES_OF_ONE_POINT = 10;
//! Sides in pixels of the squares of OUTLIERS_CLUSTERED and OUTLIERS_SECOND_MODEL.
const double CLUSTER = 80, PATCH = 160;
//! All in pixels: lengths of OUTLIERS_SHIFT, standard deviation of OUTLIERS_PLACE, side of the
//! squares of OUTLIERS_CLUSTERS, distance from the center within which about half of the
//! coordinates of OUTLIERS_CENTER are, largest offset of OUTLIERS_WINDOW per coordinate.
const double LEAST_SHIFT = 30, LARGEST_SHIFT = 100, JITTER = 0.4, SMALL_CLUSTER = 20,
             HALF_WITHIN = 20, WINDOW = 60;

//! A wrong match as from repeated texture nearby: a true match with a displacement in image 2.
void shiftedPoint(const Geometry& g, RNG& rng, Point2d& p1, Point2d& p2)
{
    do
    {
        seenPoint(g, mapsPoints(g.scene.problem), rng, p1, p2);
        const double direction = rng.uniform(0., 2 * CV_PI),
                     length = rng.uniform(MIN_SHIFT, MAX_SHIFT);
        p2 += Point2d(std::cos(direction), std::sin(direction)) * length;
    } while (!inside(p2) || pixelError(g.scene, g.scene.model, p1, p2) < MIN_SHIFT);
}

Point2d randomInSquare(RNG& rng, const Point2d& corner, double side)
{
    return corner + uniformPoint(rng, 0., side);
}

//! A point whose coordinates have a Cauchy distribution about the center, restricted to the image.
Point2d aboutCenter(RNG& rng)
{
    Point2d p;
    do
    {
        const double x = std::tan(CV_PI * rng.uniform(-0.5, 0.5)),
                     y = std::tan(CV_PI * rng.uniform(-0.5, 0.5));
        p = Point2d(SCENE_WIDTH / 2 + HALF_WITHIN * x, SCENE_HEIGHT / 2 + HALF_WITHIN * y);
    } while (!inside(p));
    return p;
}

Point2d onBorder(RNG& rng)
{
    const double at = rng.uniform(0., 2. * (SCENE_WIDTH + SCENE_HEIGHT));
    if (at < 2 * SCENE_WIDTH)
        return Point2d(std::fmod(at, SCENE_WIDTH), at < SCENE_WIDTH ? 0 : SCENE_HEIGHT);
    return Point2d(at < 2 * SCENE_WIDTH + SCENE_HEIGHT ? 0 : SCENE_WIDTH,
                   std::fmod(at - 2 * SCENE_WIDTH, SCENE_HEIGHT));
}

//! What all wrong matches of a scene have in common if they follow a structured model, that is,
//! OUTLIERS_TARGETS or a later value of OutlierModel.
struct OutlierStructure
{
    OutlierStructure(ProblemType problem, const SceneOptions& options_) : options(options_)
    {
        RNG rng(0x51ed2701 + 7919 * options.seed);
        second.problem = problem;
        secondNormal = makeGeometry(second, rng, options);
        for (int k = 0; k < 2; ++k)
        {
            target[k] = randomPixel(rng);
            corner[k] = uniformPoint(rng, SCENE_MARGIN, SCENE_WIDTH - SCENE_MARGIN - PATCH,
                                     SCENE_MARGIN, SCENE_HEIGHT - SCENE_MARGIN - PATCH);
        }
        const double direction = rng.uniform(0., 2 * CV_PI),
                     length = rng.uniform(LEAST_SHIFT, LARGEST_SHIFT);
        shift = Point2d(std::cos(direction), std::sin(direction)) * length;
        for (int k = 0; k < 2 * CLUSTERS; ++k)
            small[k] = uniformPoint(rng, SCENE_MARGIN, SCENE_WIDTH - SCENE_MARGIN - SMALL_CLUSTER,
                                    SCENE_MARGIN, SCENE_HEIGHT - SCENE_MARGIN - SMALL_CLUSTER);
    }

    //! Makes the i-th wrong match; returns false if it does not follow a structured model.
    bool match(int i, RNG& rng, Point2d& p1, Point2d& p2) const
    {
        if (!has(i))
            return false;
        const Geometry geometry(second, secondNormal, options);
        p1 = randomPixel(rng);
        p2 = randomPixel(rng);
        switch (i < options.second ? OUTLIERS_SECOND_MODEL : options.outlierModel)
        {
        case OUTLIERS_SHIFT:
            while (!inside(p2 = p1 + shift))
                p1 = randomPixel(rng);
            break;
        case OUTLIERS_PLANE: seenPoint(geometry, true, rng, p1, p2); break;
        case OUTLIERS_PLACE: p2 = target[i % options.places] + gaussianPoint(rng, JITTER); break;
        case OUTLIERS_CLUSTERS:
            p1 = randomInSquare(rng, small[rng.uniform(0, (int)CLUSTERS)], SMALL_CLUSTER);
            p2 = randomInSquare(rng, small[CLUSTERS + rng.uniform(0, (int)CLUSTERS)],
                                SMALL_CLUSTER);
            break;
        case OUTLIERS_CENTER:
            p1 = aboutCenter(rng);
            p2 = aboutCenter(rng);
            break;
        case OUTLIERS_WINDOW:
            do
                p2 = p1 + uniformPoint(rng, -WINDOW, WINDOW);
            while (!inside(p2));
            break;
        case OUTLIERS_BORDER:
            p1 = onBorder(rng);
            p2 = onBorder(rng);
            break;
        case OUTLIERS_TARGETS: p2 = target[i % 2]; break;
        case OUTLIERS_LINE:
            if (i % 2 == 0)
                p2 = target[0] +
                     (target[1] - target[0]) * ((i / 2 + 0.5) / (options.outliers / 2 + 1));
            break;
        case OUTLIERS_CLUSTERED:
            p1 = randomInSquare(rng, corner[0], CLUSTER);
            p2 = randomInSquare(rng, corner[1], CLUSTER);
            break;
        case OUTLIERS_SECOND_MODEL:
            for (int tries = 0; tries < 10000; ++tries)
                if (follow(geometry, mapsPoints(second.problem), rng,
                           p1 = randomInSquare(rng, corner[0], PATCH), p2))
                    return true;
            break;
        default: return false;
        }
        return true;
    }

    //! Returns true if the i-th wrong match follows a structured model.
    bool has(int i) const
    {
        return i < options.second ||
               (options.outlierModel >= OUTLIERS_SHIFT ? i < options.structured
                                                       : options.outlierModel >= OUTLIERS_TARGETS);
    }
    //! Returns true if the i-th wrong match has the noise of true matches.
    bool noisy(int i) const
    {
        return has(i) && (i < options.second || options.outlierModel <= OUTLIERS_PLANE);
    }
    //! Returns true if the i-th wrong match is made as with OUTLIERS_SECOND_MODEL.
    bool ofSecond(int i) const
    {
        return options.outlierModel == OUTLIERS_SECOND_MODEL || i < options.second;
    }

    enum { CLUSTERS = 5 };

    const SceneOptions& options;
    Scene second;
    Vec3d secondNormal;
    Point2d target[2], corner[2], shift, small[2 * CLUSTERS];
};

void repeatRow(Scene& scene, int from, int to)
{
    std::vector<Point2d>* const points[] = {&scene.points1, &scene.points2, &scene.clean1,
                                            &scene.clean2};
    for (int k = 0; k < 4; ++k)
        (*points[k])[to] = (*points[k])[from];
    scene.truth[to] = scene.truth[from];
    scene.onPlane[to] = scene.onPlane[from];
    scene.onSecond[to] = scene.onSecond[from];
}

//! Makes each row occur `copies` times, and shuffles all rows.
void copyRows(Scene& scene, int copies, RNG& rng)
{
    const int size = scene.size(), copied = size * copies;
    std::vector<Point2d>* const points[] = {&scene.points1, &scene.points2, &scene.clean1,
                                            &scene.clean2};
    for (int k = 0; k < 4; ++k)
        points[k]->resize(copied);
    scene.truth.resize(copied);
    scene.onPlane.resize(copied);
    scene.onSecond.resize(copied);
    for (int i = size; i < copied; ++i)
        repeatRow(scene, i % size, i);
    for (int i = copied - 1; i > 0; --i)
    {
        const int other = rng.uniform(0, i + 1);
        for (int k = 0; k < 4; ++k)
            std::swap((*points[k])[i], (*points[k])[other]);
        std::swap(scene.truth[i], scene.truth[other]);
        std::swap(scene.onPlane[i], scene.onPlane[other]);
        std::swap(scene.onSecond[i], scene.onSecond[other]);
    }
}

}  // namespace

void SceneOptions::setSize(int size, double inlierRatio)
{
    inliers = cvRound(size * inlierRatio);
    outliers = size - inliers;
}

bool mapsPoints(ProblemType problem) { return problem != FUNDAMENTAL && problem != ESSENTIAL; }

Scene makeScene(ProblemType problem, const SceneOptions& options)
{
    Scene scene;
    scene.problem = problem;
    RNG rng(0x2545f491 + 7919 * options.seed);
    const Geometry geometry(scene, makeGeometry(scene, rng, options), options);
    const OutlierStructure structure(problem, options);
    const int size = options.inliers + options.outliers, own = options.inliers - options.duplicates;
    CV_Assert(own >= 0);
    const int shared = std::min(own, options.outliers / MATCHES_OF_ONE_POINT + 1);
    const int planar = mapsPoints(problem) ? own : cvRound(own * options.planeFraction);
    std::vector<int> order(size);
    for (int i = 0; i < size; ++i)
        order[i] = i;
    for (int i = size - 1; i > 0; --i)
        std::swap(order[i], order[rng.uniform(0, i + 1)]);
    scene.points1.resize(size);
    scene.truth.assign(size, 0);
    scene.onPlane.assign(size, 0);
    scene.onSecond.assign(size, 0);
    scene.points2 = scene.clean1 = scene.clean2 = scene.points1;
    for (int i = 0; i < size; ++i)
    {
        const int row = order[i];
        if (i >= own && i < options.inliers)
        {
            repeatRow(scene, order[rng.uniform(0, own)], row);
            continue;
        }
        Point2d &p1 = scene.clean1[row], &p2 = scene.clean2[row];
        scene.truth[row] = i < own;
        scene.onPlane[row] = i < planar;
        if (i < own)
            seenPoint(geometry, i < planar, rng, p1, p2);
        else if (options.outlierModel == OUTLIERS_LOCAL)
            shiftedPoint(geometry, rng, p1, p2);
        else if (options.outlierModel == OUTLIERS_MANY_TO_ONE)
        {
            p1 = randomPixel(rng);
            p2 = scene.points2[order[rng.uniform(0, shared)]];
        }
        else if (!structure.match(i - options.inliers, rng, p1, p2))
        {
            p1 = randomPixel(rng);
            p2 = randomPixel(rng);
        }
        const double noise = i < own || structure.noisy(i - options.inliers) ? options.noise : 0;
        scene.onSecond[row] = i >= own && structure.ofSecond(i - options.inliers);
        scene.points1[row] = p1 + gaussianPoint(rng, noise);
        scene.points2[row] = p2 + gaussianPoint(rng, noise);
    }
    if (options.copies > 1)
        copyRows(scene, options.copies, rng);
    scene.scores = makeScores(scene, options);
    return scene;
}

Scene makeScene(ProblemType problem, int inliers, int outliers, uint64 seed)
{
    SceneOptions options;
    options.inliers = inliers;
    options.outliers = outliers;
    options.seed = seed;
    return makeScene(problem, options);
}

double pixelError(const Scene& scene, const Matx33d& model, const Point2d& p1, const Point2d& p2)
{
    const Vec3d x1(p1.x, p1.y, 1), x2(p2.x, p2.y, 1);
    if (mapsPoints(scene.problem))
    {
        const Vec3d y = model * x1;
        return cv::norm(Point2d(y[0] / y[2], y[1] / y[2]) - p2);
    }
    const Matx33d Kinv = scene.K.inv();
    const Matx33d F = scene.problem == FUNDAMENTAL ? model : Kinv.t() * model * Kinv;
    const Vec3d a = F * x1, b = F.t() * x2;
    return std::abs(x2.dot(a)) / std::sqrt(a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1]);
}

double angleBetween(const Mat& R, const Matx33d& truth)
{
    const Matx33d D = Matx33d(R.ptr<double>()) * truth.t();
    return std::acos(std::max(-1., std::min(1., (cv::trace(D) - 1) / 2)));
}

double angleBetween(const Mat& t, const Vec3d& truth)
{
    return std::acos(
        std::max(-1., std::min(1., Vec3d(t.ptr<double>()).dot(truth) / cv::norm(truth))));
}

double modelError(const Scene& scene, const Mat& model, ScenePart part)
{
    if (model.rows < (isAffine(scene.problem) ? 2 : 3) || model.rows > 3 || model.cols != 3 ||
        model.type() != CV_64F)
        return std::numeric_limits<double>::infinity();
    const Matx33d M = squareModel(model);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        if (!scene.truth[i] ||
            (part != TRUE_MATCHES && (scene.onPlane[i] != 0) != (part == ON_PLANE)))
            continue;
        const double error = pixelError(scene, M, scene.clean1[i], scene.clean2[i]);
        sum += error * error;
        ++count;
    }
    const double result = std::sqrt(sum / count);
    return result == result ? result : std::numeric_limits<double>::infinity();
}

Ptr<Usac> createUsac(const Scene& scene, const Params& params)
{
    if (scene.problem == ESSENTIAL)
        return Usac::create(ESSENTIAL, scene.points1, scene.points2, params, scene.K);
    return Usac::create(scene.problem, scene.points1, scene.points2, params);
}

Mat estimate(const Scene& scene, const Params& params, OutputArray mask, Report* report)
{
    return createUsac(scene, params)->run(mask, report);
}

Report reportOf(const Scene& scene, const Params& params, OutputArray mask)
{
    Report report;
    estimate(scene, params, mask, &report);
    return report;
}

bool relativePose(const Scene& scene, const Params& params, Mat& R, Mat& t, OutputArray mask,
                  RelativePose& pose)
{
    return estimateRelativePose(scene.points1, scene.points2, scene.K, noArray(), noArray(),
                                noArray(), params, R, t, mask, pose);
}

Matx33d toInternal(const Correspondences& points, const Matx33d& model)
{
    const Matx33d T1 = points.frame[0].matrix(), T2 = points.frame[1].matrix();
    const Matx33d M = points.problem->errorDimension() == 2 ? T2 * model * T1.inv()
                                                            : T2.inv().t() * model * T1.inv();
    return M * (1 / cv::norm(M));
}

Matx33d normalized(const Matx33d& model) { return model * (1 / cv::norm(model)); }

Matx33d toInput(const Correspondences& points, const Matx33d& model)
{
    const Matx33d T1 = points.frame[0].matrix(), T2 = points.frame[1].matrix();
    return points.problem->errorDimension() == 2 ? T2.inv() * model * T1 : T2.t() * model * T1;
}

double modelDistance(const Matx33d& a, const Matx33d& b)
{
    return std::min(cv::norm(a - b), cv::norm(a + b));
}

}  // namespace opencv_test
