// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "control/batch_tasks.hpp"
#include "problems/essential/cameras.hpp"
#include "two_view/essential_motion.hpp"
#include "two_view/pair_models.hpp"
#include "two_view/watermark.hpp"

// This file contains the rules that turn E, F and H into a configuration.

namespace cv {
namespace usacv20 {

namespace {

Motion motionOf(const Matx33d& E, const PairModels& models, const Mat& mask)
{
    std::vector<Vec3d> first, second;
    models.directions(mask, first, second);
    const double focal = meanFocalLength(models.camera1, models.camera2);
    return motionInFront(E, first, second, models.pixels() / focal);
}

void addRotation(const Matx33d& R, Mat& rotations) { rotations.push_back(Mat(R)); }

//! Adds the camera rotations that are compatible with the homography H of a plane or of a pure
//! rotation.
void addRotationsOfPlane(const PairModels& models, Mat& rotations)
{
    const Matx33d H = models.camera2.inv() * models.H.matrix * models.camera1;
    std::vector<Vec3d> first, second;
    models.directions(models.H.mask, first, second);
    Motion motions[2];
    if (motionsOfPlane(H, first[0], motions))
    {
        addRotation(nearestRotation(motions[0].R), rotations);
        addRotation(nearestRotation(motions[1].R), rotations);
    }
    else
        addRotation(nearestRotation(determinant(H) > 0 ? H : H * -1.), rotations);
}

//! All possible rotations of the camera, one of which is right if the matches of the pair are
//! right. There is none for a watermark, and none for a planar or panoramic pair whose inliers are
//! those of F.
Mat rotationsOf(const TwoViewGeometry& found, const PairModels& models, const PairModel& base)
{
    Mat result;
    if (found.configuration == TWO_VIEW_WATERMARK)
        return result;
    if (!found.R.empty())
        addRotation(found.R, result);
    if (found.configuration == TWO_VIEW_PLANAR && models.H)
        addRotationsOfPlane(models, result);
    if (found.configuration == TWO_VIEW_UNCALIBRATED)
        addRotation(
            motionOf(essentialOf(base.matrix, models.camera1, models.camera2), models, base.mask).R,
            result);
    return result;
}

//! Sets the configuration of a pair for which H explains most inliers and, for a pure rotation, R
//! and t.
//! @param known true if the cameras are calibrated and E or H determines the inliers
void readPlane(const PairModels& models, const PairModel& base, bool known, TwoViewGeometry& found)
{
    found.configuration = TWO_VIEW_PLANAR_OR_PANORAMIC;
    Matx33d R;
    if (!known)
        return;
    const bool turned = models.turn(base, R);
    found.configuration = turned ? TWO_VIEW_PANORAMIC : TWO_VIEW_PLANAR;
    if (!turned)
        return;
    found.R = Mat(R).clone();
    found.t = Mat::zeros(3, 1, CV_64F);
}

Mat matrixOf(const PairModel& model) { return model ? Mat(model.matrix).clone() : Mat(); }

void classify(const TwoViewPair& pair, const PairModels& models, const PairModel& base,
              TwoViewGeometry& found)
{
    const bool byEssential = &base == &models.E;
    found.configuration = byEssential ? TWO_VIEW_CALIBRATED : TWO_VIEW_UNCALIBRATED;
    found.mask = base.mask;
    found.inliers = base.inliers;
    found.report = base.report;
    found.H = matrixOf(models.H);
    found.F = matrixOf(models.F);
    if (byEssential)
    {
        found.E = matrixOf(models.E);
        found.F = Mat(models.fundamental(models.E.matrix)).clone();
        const Motion motion = motionOf(models.E.matrix, models, base.mask);
        found.R = Mat(motion.R).clone();
        found.t = Mat(motion.t).clone();
    }
    if (models.H && (&base == &models.H || models.mostlyOnPlane(base)))
        readPlane(models, base, models.calibrated() && (byEssential || &base == &models.H), found);
    if (isWatermark(pair, base.mask, PairModels::planarReach() * models.pixels()))
        found.configuration = TWO_VIEW_WATERMARK;
    if (models.calibrated())
        found.rotations = rotationsOf(found, models, base);
}

TwoViewGeometry geometryOf(const TwoViewPair& pair, const Params& params, const TwoViewRules& rules)
{
    const int64 start = getTickCount();
    TwoViewGeometry found;
    PairModels models(pair, params, rules);
    if (models.size() >= models.leastMatches())
        models.search();
    found.iterations = models.iterations;
    if (models.cancelled)  // like the report of a pair that was not begun
        found.report.stop = STOP_CANCELLED;
    else
        found.report = models.refused;
    const PairModel* const base = models.cancelled ? 0 : models.base();
    if (base)
        classify(pair, models, *base, found);
    else
    {
        found.configuration = models.cancelled ? TWO_VIEW_UNDEFINED : TWO_VIEW_DEGENERATE;
        found.mask = Mat::zeros(models.size(), 1, CV_8U);
        found.reason = models.cancelled ? String("canceled") : models.reason();
    }
    found.milliseconds = (getTickCount() - start) / getTickFrequency() * 1e3;
    return found;
}

}  // namespace

TwoViewPair::TwoViewPair() {}

TwoViewPair::TwoViewPair(const Mat& points1_, const Mat& points2_, const Mat& cameraMatrix1_,
                         const Mat& cameraMatrix2_)
    : points1(points1_), points2(points2_), cameraMatrix1(cameraMatrix1_),
      cameraMatrix2(cameraMatrix2_)
{}

TwoViewGeometry::TwoViewGeometry()
    : configuration(TWO_VIEW_UNDEFINED), inliers(0), iterations(0), milliseconds(0)
{}

TwoViewGeometry estimateTwoViewGeometry(const TwoViewPair& pair, const Params& params,
                                        const TwoViewRules& rules)
{
    rules.check(params);
    return geometryOf(pair, params, rules);
}

TwoViewGeometry estimateTwoViewGeometry(InputArray points1, InputArray points2,
                                        InputArray cameraMatrix1, InputArray cameraMatrix2,
                                        const Params& params, const TwoViewRules& rules)
{
    return estimateTwoViewGeometry(TwoViewPair(points1.getMat(), points2.getMat(),
                                               cameraMatrix1.getMat(), cameraMatrix2.getMat()),
                                   params, rules);
}

std::vector<TwoViewGeometry> estimateTwoViewGeometries(const std::vector<TwoViewPair>& pairs,
                                                       const Params& params,
                                                       const TwoViewRules& rules, int threads)
{
    rules.check(params);
    std::vector<TwoViewGeometry> results(pairs.size());
    const auto estimate = [&](int i) {
        const String mistake = mistakeOf([&] { results[i] = geometryOf(pairs[i], params, rules); });
        if (mistake.empty())
            return;
        results[i] = TwoViewGeometry();
        results[i].error = mistake;
    };
    const auto leave = [&](int i) {
        results[i].report.stop = STOP_CANCELLED;
        results[i].reason = "canceled";
    };
    forEachTask((int)pairs.size(), threads, estimate, leave);
    return results;
}

}  // namespace usacv20
}  // namespace cv
