// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "true_model.hpp"

#include <cmath>
#include "opencv2/usac/geometry.hpp"

namespace benchmark {

using cv::usacv20::ESSENTIAL;
using cv::usacv20::FUNDAMENTAL;
using cv::usacv20::HOMOGRAPHY;

namespace {

typedef cv::Vec<double, TrueModel::MAX_DIRECTIONS> Step;

//! Step of the numeric derivatives in units of the normalized image plane. The error of a central
//! difference is of the order of the squared step (1e-12), and its rounding error is about 1e-16 /
//! step = 1e-10; both are small enough for the last iterations.
const double DIFFERENCE = 1e-6;
//! Usually far fewer steps suffice, since the search starts at the true model.
const int MAX_STEPS = 60;

cv::Matx33d crossMatrix(const cv::Vec3d& v)
{
    return cv::Matx33d(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
}

double sumOfSquares(const std::vector<double>& values)
{
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i)
        sum += values[i] * values[i];
    return sum;
}

}  // namespace

TrueModel::TrueModel(const opencv_test::Scene& scene_) : scene(&scene_), R(scene_.R), t(scene_.t)
{
    const cv::Matx33d& K = scene->K;
    CV_Assert(K(0, 0) == K(1, 1) && K(0, 1) == 0);
    setMatrix(scene->problem == HOMOGRAPHY ? K.inv() * scene->model * K : crossMatrix(t) * R);
}

int TrueModel::directions() const
{
    return scene->problem == HOMOGRAPHY ? 9 : scene->problem == FUNDAMENTAL ? 8 : 6;
}

void TrueModel::setMatrix(const cv::Matx33d& M)
{
    model = M;
    if (scene->problem == FUNDAMENTAL)
    {
        cv::Vec3d s;
        cv::SVD::compute(M, s, U, Vt);
        model = U * cv::Matx33d::diag(cv::Vec3d(s[0], s[1], 0)) * Vt;
    }
    model *= 1 / cv::norm(model);
}

Step TrueModel::radial() const
{
    Step result = Step::all(0);
    const cv::Matx33d M = scene->problem == FUNDAMENTAL ? U.t() * model * Vt.t() : model;
    for (int i = 0; i < directions(); ++i)
        result[i] = scene->problem != ESSENTIAL ? M.val[i] : i < 3 ? 0 : t[i - 3];
    return result;
}

TrueModel TrueModel::moved(const Step& step) const
{
    TrueModel result(*this);
    cv::Matx33d D = cv::Matx33d::zeros();
    if (scene->problem == ESSENTIAL)
    {
        cv::Matx33d turn;
        cv::Rodrigues(cv::Vec3d(step[0], step[1], step[2]), turn);
        result.R = turn * R;
        result.t = t + cv::Vec3d(step[3], step[4], step[5]);
        result.t *= 1 / cv::norm(result.t);
        result.setMatrix(crossMatrix(result.t) * result.R);
        return result;
    }
    for (int i = 0; i < directions(); ++i)
        D.val[i] = step[i];
    result.setMatrix(model + (scene->problem == FUNDAMENTAL ? U * D * Vt : D));
    return result;
}

void TrueModel::residuals(const std::vector<int>& rows, std::vector<double>& values) const
{
    const double focal = scene->K(0, 0), cx = scene->K(0, 2), cy = scene->K(1, 2);
    values.clear();
    for (size_t i = 0; i < rows.size(); ++i)
    {
        const cv::Point2d &p1 = scene->points1[rows[i]], &p2 = scene->points2[rows[i]];
        const cv::Vec3d x1((p1.x - cx) / focal, (p1.y - cy) / focal, 1),
            x2((p2.x - cx) / focal, (p2.y - cy) / focal, 1);
        const cv::Vec3d a = model * x1;
        if (scene->problem == HOMOGRAPHY)
        {
            values.push_back(a[0] / a[2] - x2[0]);
            values.push_back(a[1] / a[2] - x2[1]);
            continue;
        }
        const cv::Vec3d b = model.t() * x2;
        values.push_back(x2.dot(a) /
                         std::sqrt(a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1]));
    }
}

void TrueModel::normalEquations(const std::vector<int>& rows, cv::Mat& A, cv::Mat& b) const
{
    const int count = directions();
    cv::Mat J((int)rows.size() * residualsOfRow(), count, CV_64F), n(count, 1, CV_64F);
    std::vector<double> values, ahead, behind;
    residuals(rows, values);
    for (int k = 0; k < count; ++k)
    {
        Step step = Step::all(0);
        step[k] = DIFFERENCE;
        moved(step).residuals(rows, ahead);
        moved(-step).residuals(rows, behind);
        for (int i = 0; i < J.rows; ++i)
            J.at<double>(i, k) = (ahead[i] - behind[i]) / (2 * DIFFERENCE);
        n.at<double>(k) = radial()[k];
    }
    A = J.t() * J;
    A += n * n.t() * (cv::trace(A)[0] / count);  // fixes the scale, which does not affect errors
    b = -J.t() * cv::Mat(J.rows, 1, CV_64F, values.data());  // OpenCV 5: Mat(values) would be 1-D
}

TrueModel TrueModel::leastSquares(const std::vector<int>& rows) const
{
    TrueModel best(*this);
    std::vector<double> values;
    best.residuals(rows, values);
    double cost = sumOfSquares(values), damping = 1e-4;
    cv::Mat A, b, x;
    best.normalEquations(rows, A, b);
    for (int k = 0; k < MAX_STEPS && damping < 1e8; ++k)
    {
        cv::Mat damped = A.clone();
        for (int i = 0; i < A.rows; ++i)
            damped.at<double>(i, i) *= 1 + damping;
        cv::solve(damped, b, x, cv::DECOMP_SVD);
        Step step = Step::all(0);
        for (int i = 0; i < x.rows; ++i)
            step[i] = x.at<double>(i);
        const TrueModel next = best.moved(step);
        next.residuals(rows, values);
        const double nextCost = sumOfSquares(values);
        if (!(nextCost < cost))
        {
            damping *= 10;
            continue;
        }
        // Near its minimum the cost is quadratic. A relative decrease below 1e-10 therefore means
        // that the distance to the minimum is less than 1e-5 of the effect of the noise.
        const bool arrived = cost - nextCost < 1e-10 * cost;
        best = next;
        cost = nextCost;
        damping *= 0.1;
        if (arrived)
            break;
        best.normalEquations(rows, A, b);
    }
    return best;
}

cv::Mat TrueModel::matrix() const
{
    const cv::Matx33d& K = scene->K;
    const cv::Matx33d Kinv = K.inv();
    const cv::Matx33d M = scene->problem == HOMOGRAPHY    ? K * model * Kinv
                          : scene->problem == FUNDAMENTAL ? Kinv.t() * model * Kinv
                                                          : model;
    return cv::Mat(M, true);
}

}  // namespace benchmark
