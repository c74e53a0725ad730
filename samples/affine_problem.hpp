// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_AFFINE_PROBLEM_HPP
#define OPENCV_USACV20_SAMPLES_AFFINE_PROBLEM_HPP

#include "opencv2/usac.hpp"

namespace custom {

using cv::usacv20::Correspondences;
using cv::usacv20::MinimalSolver;
using cv::usacv20::Model;
using cv::usacv20::NonMinimalSolver;
using cv::usacv20::Problem;
using cv::usacv20::Residual;
using cv::usacv20::SampleCost;
using cv::usacv20::X1;
using cv::usacv20::X2;
using cv::usacv20::Y1;
using cv::usacv20::Y2;

//! Distance in image 2 between x2 and A x1, where A is the 2x3 matrix and x1 is homogeneous.
class AffineError : public Residual
{
public:
    void squaredErrors(const Correspondences& p, const Model& A, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
            errors[i - begin] = (float)squared(A, p.exact[X1][i], p.exact[Y1][i], p.exact[X2][i],
                                               p.exact[Y2][i]);
    }

    void squaredErrors(const Model& A, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
            errors[i] = squared(A, c[X1][i], c[Y1][i], c[X2][i], c[Y2][i]);
    }

    bool homogeneous() const CV_OVERRIDE { return false; }

private:
    static double squared(const Model& A, double x1, double y1, double x2, double y2)
    {
        const double dx = A(0, 0) * x1 + A(0, 1) * y1 + A(0, 2) - x2,
                     dy = A(1, 0) * x1 + A(1, 1) * y1 + A(1, 2) - y2;
        return dx * dx + dy * dy;
    }
};

//! Fits the affine map with the least sum of squared errors, optionally weighted, to some matches.
//! @return false if their points in image 1 are on a line
inline bool fitAffine(const Correspondences& p, const int* indices, int count,
                      const double* weights, Model& A)
{
    cv::Matx33d N = cv::Matx33d::zeros();
    cv::Matx<double, 3, 2> r = cv::Matx<double, 3, 2>::zeros();
    for (int k = 0; k < count; ++k)
    {
        const int i = indices[k];
        const double w = weights ? weights[k] : 1, x[] = {p.exact[X1][i], p.exact[Y1][i], 1};
        for (int row = 0; row < 3; ++row)
        {
            for (int col = 0; col < 3; ++col)
                N(row, col) += w * x[row] * x[col];
            r(row, 0) += w * x[row] * p.exact[X2][i];
            r(row, 1) += w * x[row] * p.exact[Y2][i];
        }
    }
    const double size = cv::trace(N);
    if (!(cv::determinant(N) > 1e-12 * size * size * size))  // NaN fails, too
        return false;
    const cv::Matx<double, 3, 2> solution = N.inv() * r;
    A = solution.t();
    return true;
}

class AffineSolver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 3; }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        return fitAffine(points, sample, 3, 0, models[0]);
    }
};

class AffineFit : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        return fitAffine(points, indices, count, weights, model);
    }
};

class AffineProblem : public Problem
{
public:
    cv::String name() const CV_OVERRIDE { return "affine"; }
    int dimension() const CV_OVERRIDE { return 6; }
    int errorDimension() const CV_OVERRIDE { return 2; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(100, 1); }  // a rough estimate
    int normalization(int) const CV_OVERRIDE { return cv::usacv20::SCALE_EACH; }

    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        cv::Matx33d A = cv::Matx33d::eye();
        for (int row = 0; row < 2; ++row)
            for (int col = 0; col < 3; ++col)
                A(row, col) = model(row, col);
        A = points.frame[1].matrix().inv() * A * points.frame[0].matrix();
        result = A.get_minor<2, 3>(0, 0);
        return cv::checkRange(cv::Mat(A, false));
    }

    cv::Ptr<Residual> createResidual(int) const CV_OVERRIDE { return cv::makePtr<AffineError>(); }
    cv::Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return cv::makePtr<AffineSolver>();
    }
    cv::Ptr<NonMinimalSolver> createNonMinimalSolver(const cv::Ptr<Residual>&) const CV_OVERRIDE
    {
        return cv::makePtr<AffineFit>();
    }
};

}  // namespace custom

#endif
