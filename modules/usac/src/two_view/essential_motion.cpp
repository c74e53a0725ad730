// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "two_view/essential_motion.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Maximum number of matches for which inFront() is evaluated to choose a motion.
constexpr int MOST_FOR_SIDES = 500;

//! Distance of two essential matrices up to sign.
double difference(const Matx33d& a, const Matx33d& b) { return std::min(norm(a - b), norm(a + b)); }

}  // namespace

Motion motionInFront(const Matx33d& essential, const std::vector<Vec3d>& x1,
                     const std::vector<Vec3d>& x2, double limit)
{
    const size_t step = (x1.size() + MOST_FOR_SIDES - 1) / MOST_FOR_SIDES;
    Motion motions[4];
    motionsOf(essential, motions);
    int best = 0, most = -1;
    for (int k = 0; k < 4; ++k)
    {
        int count = 0;
        for (size_t i = 0; i < x1.size(); i += step)
            count += inFront(motions[k], x1[i], x2[i], limit);
        if (count > most)
            best = k;
        most = std::max(most, count);
    }
    return motions[best];
}

//! In the report on the search, the fields that describe the model are replaced with those of the
//! refinement (`sample` is empty); the threshold and the statistics remain.
void preferCheaper(EssentialMotion& best, EssentialMotion& other)
{
    if (other.essential.empty() || !(other.cost < best.cost))
        return;
    std::swap(best, other);
    const Report refinement = best.report;
    best.report = other.report;
    best.report.sample.clear();
    best.report.sigma = refinement.sigma;
    best.report.covariance = refinement.covariance;
    best.report.priorChance = refinement.priorChance;
    best.report.cost = refinement.cost;
    best.report.inliers = refinement.inliers;
    best.report.independentInliers = refinement.independentInliers;
    best.report.inlierRatio = refinement.inlierRatio;
}

EssentialMotions::EssentialMotions(const Ptr<Usac>& usac_) : usac(usac_)
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

void EssentialMotions::read(EssentialMotion& found, double threshold) const
{
    const Mat errors = usac->errors(found.essential);
    found.threshold = threshold;
    found.mask = errors <= threshold;  // NaN is not an inlier
    found.mask.setTo(1, found.mask);
    std::vector<Vec3d> first, second;
    for (int i = 0; i < found.mask.rows; ++i)
        if (found.mask.at<uchar>(i))
        {
            first.push_back(x1[i]);
            second.push_back(x2[i]);
        }
    found.inliers = (int)first.size();
    found.motion = motionInFront(found.essential, first, second, limit(found));
    found.cost = 0;
    for (int i = 0; i < errors.rows; ++i)
    {
        const double part = errors.at<double>(i) / threshold;
        found.cost += part <= 1 && seen(found, i) ? part * part : 1;
    }
}

bool EssentialMotions::otherOfPlane(const EssentialMotion& found, const Matx33d& H,
                                    const Vec3d& point, EssentialMotion& other) const
{
    Motion motions[2];
    if (!motionsOfPlane(H, point, motions))
        return false;
    const Matx33d E = found.essential, each[] = {motions[0].essential(), motions[1].essential()};
    const int same = difference(each[0], E) < difference(each[1], E) ? 0 : 1;
    other.essential = usac->refine(Mat(each[1 - same]), noArray(), noArray(), &other.report);
    CV_Assert(!other.essential.empty());
    read(other, found.threshold);
    if (difference(other.essential, E) <
        difference(each[0], each[1]) / 2)  // the refinement converged to the motion of `found`
        other.essential.release();
    return true;
}

}  // namespace usacv20
}  // namespace cv
