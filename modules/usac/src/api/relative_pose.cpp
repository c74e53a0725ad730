// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/repetitions.hpp"
#include "input/match_noise.hpp"
#include "two_view/essential_motion.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** A plane with more than this fraction of the inliers is dominant, as in PlanarMotion. If there is
a dominant plane, the second motion that explains it is reported, too. */
constexpr double DOMINANT = 0.8;
//! A match is on a plane if its error under the plane's homography is at most this many thresholds.
constexpr double ON_PLANE = 2;

bool wasStopped(const Report& report)
{
    return report.stop == STOP_TIME || report.stop == STOP_CANCELLED;
}

//! A search for the motion of two calibrated views.
class TwoViews
{
public:
    TwoViews(InputArray points1, InputArray points2, InputArray cameraMatrix1,
             InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
             const Params& params_)
        : begun(getTickCount()), params(params_),
          motions(Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix1, cameraMatrix2,
                               distCoeffs1, distCoeffs2))
    {}

    bool search(EssentialMotion& found)
    {
        found.essential = motions.usac->run(found.mask, &found.report);
        if (!found.essential.empty())
            motions.read(found, found.report.threshold);
        return !found.essential.empty();
    }

    //! Finds the second motion that explains a dominant plane. @return number of inliers on the
    //! plane; 0: no plane is dominant, the plane's homography does not determine two motions, or
    //! the run was stopped
    int otherOfPlane(EssentialMotion& found, EssentialMotion& other)
    {
        Matx33d H;
        Vec3d point;
        const int onPlane = plane(found, H, point);
        const bool dominant = onPlane > DOMINANT * found.inliers;
        if (!dominant || !motions.otherOfPlane(found, H, point, other))
            return 0;
        if (wasStopped(other.report))
            found.report.stop = other.report.stop;
        return onPlane;
    }

    //! Sets the mask to 0 for inliers that are not in front of both cameras. @return their number
    int hideBehind(EssentialMotion& found) const
    {
        int behind = 0;
        for (int i = 0; i < found.mask.rows; ++i)
        {
            uchar& inlier = found.mask.at<uchar>(i);
            const bool hidden = inlier && !motions.seen(found, i);
            behind += hidden;
            inlier = inlier && !hidden;
        }
        return behind;
    }

    //! Number of inliers of the final mask without repetitions, see Report::independentInliers.
    //! The cells of this count are squares on the normalized image planes.
    int independentInliers(const EssentialMotion& found) const
    {
        Arena arena;
        const int rows = found.mask.rows, coordinates[] = {2, 2};
        double* columns[4];
        for (int k = 0; k < 4; ++k)
        {
            columns[k] = arena.take<double>(rows);
            for (int i = 0; i < rows; ++i)
                columns[k][i] = k < 2 ? motions.x1[i][k] : motions.x2[i][k - 2];
        }
        const double limit = motions.limit(found);
        return usacv20::independentInliers(columns, coordinates, found.mask.ptr(), rows, limit,
                                           limit, arena);
    }

private:
    /** Finds the homography of the plane with the largest number of inliers, and the image of one
    point of this plane in image 1. If the search for the plane is stopped, its stop reason becomes
    the stop reason of `found`.
    @return number of inliers on the plane; 0: none was found, or the run was stopped */
    int plane(EssentialMotion& found, Matx33d& H, Vec3d& point) const
    {
        if (found.report.stop == STOP_TIME || found.report.stop == STOP_CANCELLED)
            return 0;
        const double pixels = 1 / motions.usac->points().unit;
        std::vector<Point2d> first, second;
        std::vector<int> rows;
        for (int i = 0; i < found.mask.rows; ++i)
            if (found.mask.at<uchar>(i))
            {
                first.push_back(Point2d(motions.x1[i][0], motions.x1[i][1]) * pixels);
                second.push_back(Point2d(motions.x2[i][0], motions.x2[i][1]) * pixels);
                rows.push_back(i);
            }
        const Params options = optionsOfPlane(found, rows);
        if (params.maxTime > 0 && !(options.maxTime > 0))
        {
            found.report.stop = STOP_TIME;
            return 0;
        }
        Mat mask;
        Report report;
        const Mat map = estimateHomography(first, second, options, mask, report);
        if (wasStopped(report))
            found.report.stop = report.stop;
        if (wasStopped(report) || map.empty())
            return 0;
        const Matx33d scale(pixels, 0, 0, 0, pixels, 0, 0, 0, 1),
            inverse(1 / pixels, 0, 0, 0, 1 / pixels, 0, 0, 0, 1);
        H = inverse * Matx33d(map.ptr<double>()) * scale;
        for (size_t i = rows.size(); i-- > 0;)
            if (mask.at<uchar>((int)i))
                point = motions.x1[rows[i]];
        return countNonZero(mask);
    }

    //! Options of the search for the plane among the inliers in the given rows: among others, the
    //! time that is left and, if there are Params::sigmas, one sigma for each inlier. Each sigma is
    //! divided by the mean sigma, because plane() passes points in units of the mean sigma, and
    //! clamped to the limits of Params::sigmas.
    Params optionsOfPlane(const EssentialMotion& found, const std::vector<int>& rows) const
    {
        Params options;
        options.threshold = ON_PLANE * found.threshold;
        options.seed = params.seed;
        options.significance = 1;
        if (params.maxTime > 0)
            options.maxTime = params.maxTime - (getTickCount() - begun) / getTickFrequency() * 1e3;
        if (params.sigmas.empty())
            return options;
        const MatchNoise noise(*motions.usac->points().problem, params.sigmas,
                               (int)motions.x1.size());
        for (int row : rows)
            options.sigmas.push_back(
                (float)std::min(std::max(noise.sigma(row) / noise.mean(), 1e-6), 1e6));
        return options;
    }

    const int64 begun;  //!< time at which the run began, in ticks
    const Params params;
    const EssentialMotions motions;
};

}  // namespace

RelativePose::RelativePose() : behind(0), onPlane(0), otherInliers(0) {}

bool estimateRelativePose(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                          InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
                          const Params& params, OutputArray R, OutputArray t, OutputArray mask,
                          RelativePose& pose)
{
    pose = RelativePose();
    TwoViews views(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2,
                   params);
    EssentialMotion best, other;
    const bool found = views.search(best);
    if (found)
    {
        pose.onPlane = views.otherOfPlane(best, other);
        preferCheaper(best, other);
        pose.behind = views.hideBehind(best);
        best.report.inliers = countNonZero(best.mask);
        best.report.independentInliers = views.independentInliers(best);
        best.report.inlierRatio = (double)best.report.inliers / std::max(best.mask.rows, 1);
        pose.essential = best.essential;
        Mat(best.motion.R).copyTo(R);
        Mat(best.motion.t).copyTo(t);
    }
    else
    {
        R.release();
        t.release();
    }
    if (!other.essential.empty())
    {
        views.hideBehind(other);
        pose.otherR = Mat(other.motion.R).clone();
        pose.otherT = Mat(other.motion.t).clone();
        pose.otherInliers = countNonZero(other.mask);
    }
    pose.report = best.report;
    if (mask.needed())
        best.mask.copyTo(mask);
    return found;
}

}  // namespace usacv20
}  // namespace cv
