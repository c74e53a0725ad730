// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/lens_oracle.hpp"
#include "opencv2/usac/geometry.hpp"

using cv::Mat;
using cv::Matx22d;
using cv::Matx33d;
using cv::Point2d;
using cv::Point3d;
using cv::Vec2d;
using cv::Vec3d;

namespace opencv_test {

namespace {

//! Largest accepted residual of Newton's method, relative to 1 plus the distorted radius: twice the
//! module's limit of 1e-11.
const double LEFT = 2e-11;
const int STEPS = 2000, FOLD_STEPS = 100;
//! Shortest step in the search for a radius, relative to the distorted radius.
const double SHORTEST = 1e-12;

}  // namespace

LensOracle::LensOracle(const Mat& distortion) : d()
{
    Mat doubles;
    distortion.convertTo(doubles, CV_64F);
    for (int i = 0; i < (int)doubles.total(); ++i)
        d[i] = doubles.ptr<double>()[i];
}

//! Distorted radius of a point with radius r, from the radial terms only. NaN at or beyond a pole.
double LensOracle::radial(double r) const
{
    const double q = r * r, below = 1 + q * (d[5] + q * (d[6] + q * d[7]));
    return below > 0 ? r * (1 + q * (d[0] + q * (d[1] + q * d[4]))) / below : NAN;
}

//! Returns true if radial() increases strictly between STEPS equidistant radii up to `radius`.
bool LensOracle::grows(double radius) const
{
    double before = 0;
    for (int i = 1; i <= STEPS; ++i)
    {
        const double now = radial(radius * i / STEPS);
        if (!(now > before))
            return false;
        before = now;
    }
    return true;
}

//! Computes the starting point of Newton's method: inverts the radial terms alone, in small steps
//! from the center outward.
LensOracle::Answer LensOracle::startOf(const Vec2d& seen, Vec2d& point) const
{
    const double wanted = cv::norm(seen);
    const bool onlyRadial = d[2] == 0 && d[3] == 0 && d[8] == 0 && d[9] == 0 && d[10] == 0 &&
                            d[11] == 0 && d[12] == 0 && d[13] == 0;
    double r = 0, before = 0;
    double step = wanted / STEPS;
    while (before < wanted && r < 100 * (1 + wanted))
    {
        const double now = radial(r + step);
        if (now > before)
        {
            before = now;
            r += step;
        }
        else if (step > SHORTEST * wanted)  // this step might have crossed a pole
            step /= 2;
        else
            return onlyRadial && before < wanted * (1 - OFF_FOLD) ? NOT_SEEN : UNDECIDED;
    }
    point = wanted > 0 ? seen * (r / wanted) : seen;
    return before >= wanted ? SEEN : UNDECIDED;
}

//! Distorts the point with cv::projectPoints.
//! @param J output, derivative of the result with respect to the point
//! @param rounding output, bound of the rounding error of the result
Vec2d LensOracle::distort(const Vec2d& point, Matx22d& J, double& rounding) const
{
    std::vector<Point2d> image;
    Mat derivative;  // derivatives of the image point with respect to rvec, tvec, focal lengths,
                     // principal point and coefficients
    cv::projectPoints(std::vector<Point3d>(1, Point3d(point[0], point[1], 1)), Vec3d(), Vec3d(),
                      Matx33d::eye(), Mat(1, 14, CV_64F, const_cast<double*>(d)), image,
                      derivative);
    rounding = 1 + std::abs(point[0]) + std::abs(point[1]);
    for (int row = 0; row < 2; ++row)
    {
        J(row, 0) = derivative.at<double>(row, 3);
        J(row, 1) = derivative.at<double>(row, 4);
        for (int k = 10; k < derivative.cols; ++k)
            rounding += std::abs(derivative.at<double>(row, k) * d[k - 10]);
    }
    rounding *= ROUNDING;
    return Vec2d(image[0].x, image[0].y);
}

//! Returns true if the distortion preserves orientation at FOLD_STEPS equidistant points between
//! the center and a point. Otherwise a fold may hide the point from the camera.
bool LensOracle::unfolded(const Vec2d& point) const
{
    Matx22d J;
    double rounding;
    for (int i = 1; i <= FOLD_STEPS; ++i)
    {
        distort(point * ((double)i / FOLD_STEPS), J, rounding);
        if (!(determinant(J) > 0))
            return false;
    }
    return true;
}

LensOracle::Answer LensOracle::invert(Bounded& x, Bounded& y) const
{
    const Vec2d seen((double)x.value, (double)y.value);
    if (!(cv::norm(seen) < 1e6))
        return UNDECIDED;
    Vec2d point;
    const Answer start = startOf(seen, point);
    if (start != SEEN)
        return start;
    Matx22d J;
    double rounding = 0;
    Vec2d left;
    for (int i = 0; i < 30; ++i)
    {
        left = distort(point, J, rounding) - seen;
        if (!(std::abs(determinant(J)) > 1e-9))
            return UNDECIDED;
        if (cv::norm(left) > rounding)
            point -= J.inv() * left;
    }
    if (!(cv::norm(left) <= LEFT * (1 + cv::norm(seen))) ||
        !grows(cv::norm(point) * (1 + OFF_FOLD)) || !unfolded(point * (1 + OFF_FOLD)))
        return UNDECIDED;
    const double bound = 2 * cv::norm(J.inv()) *
                         (LEFT * (1 + cv::norm(seen)) + rounding + (double)(x.error + y.error));
    x = Bounded(point[0], bound);
    y = Bounded(point[1], bound);
    return SEEN;
}

}  // namespace opencv_test
