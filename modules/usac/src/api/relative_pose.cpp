// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/repetitions.hpp"
#include "input/match_noise.hpp"
#include "problems/essential/motions.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** A plane with more than this fraction of the inliers is dominant, as in PlanarMotion. If there is
a dominant plane, the second motion that explains it is reported, too.
doc/measurements/constants_tables.md shows the effects of other values. */
constexpr double DOMINANT = 0.8;
//! A match is on a plane if its error under the plane's homography is at most this many thresholds.
//! doc/measurements/constants_tables.md shows the effects of other values.
constexpr double ON_PLANE = 2;

//! The essential matrix of two views and the motion derived from it.
class TwoViews
{
public:
    TwoViews(InputArray points1, InputArray points2, InputArray cameraMatrix1,
             InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
             const Params& params_)
        : begun(getTickCount()), params(params_),
          usac(Usac::create(ESSENTIAL, points1, points2, params, cameraMatrix1, cameraMatrix2,
                            distCoeffs1, distCoeffs2)),
          unit(usac->points().unit)
    {
        const Correspondences& p = usac->points();
        x1.assign(p.inputSize, Vec3d(NAN, NAN, NAN));
        x2 = x1;
        for (int i = 0; i < p.size; ++i)
        {
            x1[p.inputIndex[i]] = Vec3d(p.exact[X1][i], p.exact[Y1][i], 1);
            x2[p.inputIndex[i]] = Vec3d(p.exact[X2][i], p.exact[Y2][i], 1);
        }
    }

    //! A model with its mask, its motion and the report of the search or refinement that found it.
    struct Solution
    {
        Mat essential, mask;
        Report report;
        Motion motion;
        double threshold;  //!< threshold of the mask
        int inliers;       //!< inliers of the essential matrix, including points behind a camera
        double cost;  //!< sum of squared errors, in squared thresholds; a point counts as 1 if it
                      //!< is an outlier or not in front of both cameras
    };

    bool search(Solution& found)
    {
        found.essential = usac->run(found.mask, &found.report);
        if (!found.essential.empty())
            read(found, found.report.threshold);
        return !found.essential.empty();
    }

    //! Finds the second motion that explains a dominant plane. @return number of inliers on the
    //! plane; 0: no plane is dominant, the plane's homography does not determine two motions, or
    //! the run was stopped
    int otherOfPlane(Solution& found, Solution& other)
    {
        Matx33d H;
        Vec3d point;
        const int onPlane = plane(found, H, point);
        Motion motions[2];
        if (onPlane <= DOMINANT * found.inliers || !motionsOfPlane(H, point, motions))
            return 0;
        const Matx33d E = found.essential,
                      each[] = {motions[0].essential(), motions[1].essential()};
        const int same = difference(each[0], E) < difference(each[1], E) ? 0 : 1;
        other.essential = usac->refine(Mat(each[1 - same]), noArray(), noArray(), &other.report);
        CV_Assert(!other.essential.empty());
        read(other, found.report.threshold);
        if (difference(other.essential, E) <
            difference(each[0], each[1]) / 2)  // the refinement converged to the motion of `found`
            other.essential.release();
        return onPlane;
    }

    //! Sets the mask to 0 for inliers that are not in front of both cameras. @return their number
    int hideBehind(Solution& solution) const
    {
        int behind = 0;
        for (int i = 0; i < solution.mask.rows; ++i)
        {
            uchar& inlier = solution.mask.at<uchar>(i);
            const bool hidden = inlier && !inFront(solution.motion, x1[i], x2[i], limit(solution));
            behind += hidden;
            inlier = inlier && !hidden;
        }
        return behind;
    }

    //! Number of inliers of the final mask without repetitions, see Report::independentInliers.
    //! The cells of this count are squares on the normalized image planes.
    int independentInliers(const Solution& solution) const
    {
        Arena arena;
        const int rows = solution.mask.rows, coordinates[] = {2, 2};
        double* columns[4];
        for (int k = 0; k < 4; ++k)
        {
            columns[k] = arena.take<double>(rows);
            for (int i = 0; i < rows; ++i)
                columns[k][i] = k < 2 ? x1[i][k] : x2[i][k - 2];
        }
        return usacv20::independentInliers(columns, coordinates, solution.mask.ptr(), rows,
                                           limit(solution), limit(solution), arena);
    }

private:
    //! Of the four motions of the essential matrix, selects the one with the most inliers in front
    //! of both cameras, and computes the other members of the solution.
    //! @param threshold threshold of the search, also if `solution` is the result of a refinement:
    //! a threshold estimated in the refinement could differ, and the two motions of a plane are
    //! comparable only with the same threshold
    void read(Solution& solution, double threshold)
    {
        const Mat errors = usac->errors(solution.essential);
        solution.threshold = threshold;
        solution.mask = errors <= threshold;  // NaN is not an inlier
        solution.mask.setTo(1, solution.mask);
        solution.inliers = countNonZero(solution.mask);
        Motion motions[4];
        motionsOf(solution.essential, motions);
        int most = -1;
        for (int k = 0; k < 4; ++k)
        {
            const int count = countInFront(motions[k], solution);
            if (count <= most)
                continue;
            most = count;
            solution.motion = motions[k];
        }
        solution.cost = 0;
        for (int i = 0; i < errors.rows; ++i)
        {
            const double part = errors.at<double>(i) / threshold;
            const bool counts = part <= 1 &&
                                inFront(solution.motion, x1[i], x2[i], limit(solution));
            solution.cost += counts ? part * part : 1;
        }
    }

    int countInFront(const Motion& motion, const Solution& solution) const
    {
        int count = 0;
        for (int i = 0; i < solution.mask.rows; ++i)
            count += solution.mask.at<uchar>(i) && inFront(motion, x1[i], x2[i], limit(solution));
        return count;
    }

    //! Inlier threshold on the normalized image planes.
    double limit(const Solution& solution) const { return unit * solution.threshold; }

    /** Finds the homography of the plane with the largest number of inliers, and the image of one
    point of this plane in image 1. If the search for the plane is stopped, its stop reason becomes
    the stop reason of `found`.
    @return number of inliers on the plane; 0: none was found, or the run was stopped */
    int plane(Solution& found, Matx33d& H, Vec3d& point) const
    {
        if (found.report.stop == STOP_TIME || found.report.stop == STOP_CANCELLED)
            return 0;
        const double pixels = 1 / unit;
        std::vector<Point2d> first, second;
        std::vector<int> rows;
        for (int i = 0; i < found.mask.rows; ++i)
            if (found.mask.at<uchar>(i))
            {
                first.push_back(Point2d(x1[i][0], x1[i][1]) * pixels);
                second.push_back(Point2d(x2[i][0], x2[i][1]) * pixels);
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
        const bool stopped = report.stop == STOP_TIME || report.stop == STOP_CANCELLED;
        if (stopped)
            found.report.stop = report.stop;
        if (stopped || map.empty())
            return 0;
        const Matx33d scale(pixels, 0, 0, 0, pixels, 0, 0, 0, 1),
            inverse(1 / pixels, 0, 0, 0, 1 / pixels, 0, 0, 0, 1);
        H = inverse * Matx33d(map.ptr<double>()) * scale;
        for (size_t i = rows.size(); i-- > 0;)
            if (mask.at<uchar>((int)i))
                point = x1[rows[i]];
        return countNonZero(mask);
    }

    //! Options of the search for the plane among the inliers in the given rows: among others, the
    //! time that is left and, if there are Params::sigmas, one sigma for each inlier. Each sigma is
    //! divided by the mean sigma, because plane() passes points in units of the mean sigma, and
    //! clamped to the limits of Params::sigmas.
    Params optionsOfPlane(const Solution& found, const std::vector<int>& rows) const
    {
        Params options;
        options.threshold = ON_PLANE * found.threshold;
        options.seed = params.seed;
        options.significance = 1;
        if (params.maxTime > 0)
            options.maxTime = params.maxTime - (getTickCount() - begun) / getTickFrequency() * 1e3;
        if (params.sigmas.empty())
            return options;
        const MatchNoise noise(*usac->points().problem, params.sigmas, (int)x1.size());
        for (int row : rows)
            options.sigmas.push_back(
                (float)std::min(std::max(noise.sigma(row) / noise.mean(), 1e-6), 1e6));
        return options;
    }

    //! Distance of two essential matrices up to sign.
    static double difference(const Matx33d& a, const Matx33d& b)
    {
        return std::min(norm(a - b), norm(a + b));
    }

    const int64 begun;  //!< time at which the run began, in ticks
    const Params params;
    const Ptr<Usac> usac;
    const double unit;          //!< see Correspondences::unit: about the size of a pixel on the
                                //!< normalized image planes
    std::vector<Vec3d> x1, x2;  //!< undistorted points on the normalized image planes; NaN for
                                //!< matches that are not finite
};

//! The report of a search whose model has been replaced with a refined one: the fields that
//! describe the model come from the report of the refinement (`sample` is empty); the threshold and
//! the statistics are those of the search.
Report reportOf(const Report& search, const Report& refinement)
{
    Report report = search;
    report.sample.clear();
    report.sigma = refinement.sigma;
    report.covariance = refinement.covariance;
    report.priorChance = refinement.priorChance;
    report.cost = refinement.cost;
    return report;
}

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
    TwoViews::Solution best, other;
    const bool found = views.search(best);
    if (found)
    {
        pose.onPlane = views.otherOfPlane(best, other);
        if (!other.essential.empty() && other.cost < best.cost)
        {
            std::swap(best, other);
            best.report = reportOf(other.report, best.report);
        }
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
