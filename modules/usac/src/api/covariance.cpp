// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/decompositions.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/predictions.hpp"
#include "problems/registry.hpp"
#include "input/read_arrays.hpp"

namespace cv {
namespace usacv20 {

namespace {

typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Numbers;

//! Largest accepted Frobenius norm of two differences in covarianceOfPose(): between the caller's
//! essential matrix and [t]x R, both of unit norm; and between R R^T and the identity.
constexpr double SAME = 1e-6;

Mat toMat(const Numbers& numbers)
{
    Mat result((int)numbers.rows(), (int)numbers.cols(), CV_64F);
    Eigen::Map<Numbers>(result.ptr<double>(), numbers.rows(), numbers.cols()) = numbers;
    return result;
}

//! Reads a matrix of the caller with `rows` x `cols` numbers of any depth. The result is empty if
//! the matrix has another shape or several channels.
Mat readMatrix(InputArray given, int rows, int cols)
{
    const Mat matrix = given.getMat();
    Mat numbers;
    if (matrix.dims <= 2 && matrix.channels() == 1 && matrix.rows == rows && matrix.cols == cols)
        matrix.convertTo(numbers, CV_64F);
    return numbers;
}

//! A model of the caller in two forms, which can differ in scale and sign: `normal`, as models are
//! returned (see Problem::toInput), and `here`, as Parameterization::plus returns it.
class GivenModel
{
public:
    GivenModel(ProblemType type, InputArray given)
        : problem(createProblem(type, Matx33d::eye(), noArray(), noArray(), noArray())),
          rule(problem->createParameterization()), points(), isMap(type == HOMOGRAPHY)
    {
        const Mat matrix = given.getMat();
        Mat numbers;
        if (matrix.dims <= 2 && matrix.channels() == 1 && matrix.total() <= MAX_MODEL_SIZE)
            matrix.convertTo(numbers, CV_64F);
        Model searched;
        const bool usable = !numbers.empty() && checkRange(numbers) &&
                            problem->fromOutput(
                                std::vector<double>(numbers.begin<double>(), numbers.end<double>()),
                                points, searched) &&
                            problem->toInput(searched, points, normal) &&
                            problem->toOutput(normal).size() == numbers.size() &&
                            callerBasis(*rule, normal, basis);
        if (!usable)
            CV_Error_(
                Error::StsBadArg,
                ("model: the %d x %d numbers with %d channel(s) are not a model of the problem "
                 "%s",
                 matrix.rows, matrix.cols, matrix.channels(), problem->name().c_str()));
        here = rule->plus(normal, std::vector<double>(rule->dimension()).data());
    }

    int dimension() const { return rule->dimension(); }
    //! The model in the scale and sign in which models are returned, see Problem::toInput.
    const Model& model() const { return normal; }
    const Problem& kind() const { return *problem; }

    //! Derivatives of all entries of model() with respect to the parameters to which
    //! Report::covariance refers, see Parameterization::smooth.
    Numbers tangent() const
    {
        if (!problem->createResidual(RESIDUAL_STANDARD)->homogeneous())
            return basis;
        const int last = normal.size() - 1;
        const Eigen::Map<const Eigen::VectorXd> entries(normal.val, normal.size()),
            unscaled(here.val, here.size());
        if (!isMap || normal.val[last] != 1)  // then `normal` is equal to `here` up to sign
            return basis * (entries.dot(unscaled) < 0 ? -1. : 1.);
        // `normal` is `here` divided by its last entry: derivatives of a quotient
        return (basis - entries * basis.row(last)) / here.val[last];
    }

    //! The derivatives of only those entries that Problem::toOutput() returns to the caller.
    Numbers tangentOfOutput() const { return tangent().topRows(problem->toOutput(normal).total()); }

    Numbers covariance(InputArray given) const
    {
        const int d = dimension();
        const Mat numbers = readMatrix(given, d, d);
        if (numbers.empty())
            CV_Error_(Error::StsBadArg, ("covariance: a %d x %d matrix is expected for the problem "
                                         "%s, not %d x %d numbers with %d channel(s)",
                                         d, d, problem->name().c_str(), given.getMat().rows,
                                         given.getMat().cols, given.getMat().channels()));
        return Eigen::Map<const Numbers>(numbers.ptr<double>(), d, d);
    }

private:
    const Ptr<Problem> problem;
    const Ptr<Parameterization> rule;
    const Correspondences points;  //!< no points, and a frame that changes no coordinates
    const bool isMap;              //!< homography: its last entry is 1, or nearly 0 (unit norm)
    Model normal, here;
    AnyParameterization::Basis basis;  //!< derivatives of `here`, see callerBasis()
};

}  // namespace

Mat tangentOfModel(ProblemType problem, InputArray model)
{
    return toMat(GivenModel(problem, model).tangentOfOutput());
}

Mat covarianceOfModel(ProblemType problem, InputArray model, InputArray covariance)
{
    const GivenModel given(problem, model);
    const Numbers T = given.tangentOfOutput();
    return toMat(T * given.covariance(covariance) * T.transpose());
}

Mat covarianceOfPose(InputArray essential, InputArray covariance, InputArray R, InputArray t)
{
    const GivenModel given(ESSENTIAL, essential);
    const Numbers C = given.covariance(covariance);
    const Mat rotation = readMatrix(R, 3, 3);
    Mat translation = readMatrix(t, 3, 1);
    if (translation.empty())
        translation = readMatrix(t, 1, 3);
    if (rotation.empty() ||
        !(norm(Matx33d(rotation) * Matx33d(rotation).t(), Matx33d::eye()) <= SAME) ||
        !(determinant(rotation) > 0))
        CV_Error(Error::StsBadArg, "R: a 3 x 3 rotation matrix is expected");
    if (translation.empty() || !(norm(translation) > 0 && norm(translation) <= DBL_MAX))
        CV_Error(Error::StsBadArg, "t: three numbers are expected, not all 0");
    const RowMajor3 turn = Eigen::Map<const RowMajor3>(rotation.ptr<double>());
    const Eigen::Vector3d direction = Eigen::Map<const Eigen::Vector3d>(translation.ptr<double>())
                                          .normalized();
    const RowMajor3 E = turnedAbout(direction, turn) * std::sqrt(0.5);
    const Eigen::Map<const RowMajor3> normal(given.model().val);
    if ((E * normal.cwiseProduct(E).sum() - normal).norm() > SAME)
        CV_Error(Error::StsBadArg,
                 "R and t: [t]x R is expected to be a multiple of the essential matrix");
    // derivatives of E with respect to the rotation vector and to changes of t in two directions
    // perpendicular to t
    Eigen::Matrix<double, 9, 5> byMotion;
    const Eigen::Vector3d across[2] = {direction.unitOrthogonal(),
                                       direction.cross(direction.unitOrthogonal())};
    for (int k = 0; k < 5; ++k)
    {
        const RowMajor3 change = std::sqrt(0.5) *
                                 (k < 3 ? turnedAbout(direction,
                                                      turnedAbout(Eigen::Vector3d::Unit(k), turn))
                                        : turnedAbout(across[k - 3], turn));
        byMotion.col(k) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(change.data());
    }
    const Numbers motion = solveLeastSquares(byMotion, given.tangent());
    Numbers result(6, 5);
    result.topRows(3) = motion.topRows(3);
    result.bottomRows(3) = across[0] * motion.row(3) + across[1] * motion.row(4);
    return toMat(result * C * result.transpose());
}

Mat pointCovariance(ProblemType problem, InputArray model, InputArray covariance,
                    InputArray points1, InputArray points2, InputArray cameraMatrix1,
                    InputArray cameraMatrix2)
{
    const GivenModel given(problem, model);
    const Numbers C = given.covariance(covariance), T = given.tangent();
    const Prediction prediction(problem, cameraMatrix1, cameraMatrix2);
    Arena arena;
    Arena::Scope scope(arena);
    const Mat first = readPoints(points1.getMat(), given.kind().coordinates(0), "points1", scope);
    Mat second;
    if (prediction.needsBoth())
    {
        second = readPoints(points2.getMat(), given.kind().coordinates(1), "points2", scope);
        if (second.rows != first.rows)
            CV_Error_(
                Error::StsUnmatchedSizes,
                ("points1 and points2: lists of the same length are expected, not of %d and %d",
                 first.rows, second.rows));
    }
    const int k = prediction.components();
    Mat result(first.rows, k * k, CV_64F);
    double datum[MAX_COLUMNS];
    Numbers derivative(k, given.model().size());
    for (int i = 0; i < first.rows; ++i)
    {
        std::copy(first.ptr<double>(i), first.ptr<double>(i) + first.cols, datum);
        if (!second.empty())
            std::copy(second.ptr<double>(i), second.ptr<double>(i) + second.cols,
                      datum + first.cols);
        prediction.linearize(given.model(), datum, derivative.data());
        const Numbers J = derivative * T, one = J * C * J.transpose();
        for (int j = 0; j < k * k; ++j)
            result.at<double>(i, j) = std::abs(one.data()[j]) <= DBL_MAX
                                          ? one.data()[j]
                                          : std::numeric_limits<double>::quiet_NaN();
    }
    return result;
}

}  // namespace usacv20
}  // namespace cv
