// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PROBLEM_OBJECTS_HPP
#define OPENCV_USACV20_TEST_PROBLEM_OBJECTS_HPP

#include <Eigen/Core>
#include "problems/affinity/affinity.hpp"
#include "problems/essential/essential.hpp"
#include "problems/fundamental/fundamental.hpp"
#include "problems/homography/homography.hpp"
#include "problems/similarity/similarity.hpp"
#include "problems/two_view/two_view.hpp"

namespace opencv_test {

//! The built-in problem of a type, with the unit matrix as camera matrix. There is one object for
//! each type, which exists until the program ends.
const cv::usacv20::Problem& problemObject(cv::usacv20::ProblemType type);

//! The formulas of residuals, in the order of the list `Errors` in problems/errors.hpp.
struct Formula
{
    enum Kind {
        TRANSFER,
        SYMMETRIC_TRANSFER,
        SAMPSON,
        SYMMETRIC_EPIPOLAR,
        REPROJECTION,
        SPACE_TRANSFER,
        WHITENED_TRANSFER,
        WHITENED_SAMPSON,
        WHITENED_REPROJECTION
    };
};

//! The built-in residual of a formula, which must be one of the first four of Formula::Kind.
cv::Ptr<cv::usacv20::Residual> residualOf(Formula::Kind kind);

//! The least-squares solver of the problem for the residual of a formula.
cv::Ptr<cv::usacv20::NonMinimalSolver> createLeastSquaresSolver(cv::usacv20::ProblemType type,
                                                                Formula::Kind kind);

//! The parameterization of any problem around a model, with Eigen matrices of dynamic size.
class Parameterization
{
public:
    typedef Eigen::MatrixXd Basis;
    typedef Eigen::VectorXd Step;

    Parameterization(cv::usacv20::ProblemType type, const cv::usacv20::Model& model);
    Parameterization(const cv::usacv20::Problem* problem, const cv::usacv20::Model& model);

    bool hasFullRank() const;
    int dimension() const;
    Basis tangent() const;
    Parameterization plus(const Step& step) const;
    cv::usacv20::Model model() const;

private:
    cv::Ptr<cv::usacv20::Parameterization> rule;
    cv::usacv20::Model given;
};

}  // namespace opencv_test

#endif
