// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/homography/homography.hpp"
#include "problems/homography/homography_parameterization.hpp"
#include "problems/two_view/two_view.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The map from image 1 to image 2 of a plane, or of any scene under pure rotation: x2 ~ H x1.
class HomographyProblem : public Problem
{
public:
    String name() const CV_OVERRIDE { return "homography"; }
    int dimension() const CV_OVERRIDE { return HomographyParameterization::DIMENSION; }
    int errorDimension() const CV_OVERRIDE { return 2; }
    //! Time per sample in point tests (see SampleCost), and number of models per sample; both were
    //! measured.
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(250, 1); }

    //! The transfer error is measured in image 2, so that the scale of image 1 does not matter;
    //! errors in both images need a common scale.
    int normalization(int residual) const CV_OVERRIDE
    {
        return residual == RESIDUAL_SYMMETRIC ? SCALE_COMMON : SCALE_EACH;
    }

    //! The result is scaled to h33 = 1, unless h33 is nearly 0 relative to the other terms of the
    //! denominator h31 x + h32 y + h33; in that case the result has unit norm.
    bool toInput(const Model& model, const Correspondences& points,
                 Model& inInput) const CV_OVERRIDE
    {
        const Matx33d T1 = points.frame[0].matrix(), T2 = points.frame[1].matrix();
        const double s = 1 / T2(0, 0);
        // T2 scales and translates, so that its inverse is simple
        const Matx33d inverse(s, 0, -s * T2(0, 2), 0, s, -s * T2(1, 2), 0, 0, 1);
        Matx33d result = inverse * Matx33d(model) * T1;
        if (!toUnitNorm(result))
            return false;
        const double weights = std::abs(result(2, 0)) * (std::abs(T1(0, 2)) + 1) / T1(0, 0) +
                               std::abs(result(2, 1)) * (std::abs(T1(1, 2)) + 1) / T1(0, 0);
        if (std::abs(result(2, 2)) > 1e-12 * weights)
        {
            result *= 1 / result(2, 2);
            result(2, 2) = 1;  // exactly, without the rounding error of the product
        }
        inInput = result;
        return true;
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE { return Matx33d(output.ptr<double>()); }

    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        if (output.size() != 9)
            return false;
        Matx33d H = points.frame[1].matrix() * Matx33d(output.data()) *
                    points.frame[0].matrix().inv();
        const bool usable = toUnitNorm(H);
        model = H;
        return usable;
    }

    Ptr<Residual> createResidual(int type) const CV_OVERRIDE
    {
        return type == RESIDUAL_SYMMETRIC ? createResidualOf<SymmetricTransferError>()
                                          : createResidualOf<TransferError>();
    }

    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return createHomography4Solver(); }

    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<HomographyParameterization>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createHomographyFit(residual);
    }

    void createDegeneracies(int flags, std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE
    {
        if (flags & DEGENERACY_ORIENTATION)  // first, because it rejects the most samples
            degeneracies.push_back(createHomographyOrientation());
        if (flags & DEGENERACY_REPEATED)
        {
            degeneracies.push_back(createRepeatedPoints());
            degeneracies.push_back(createCrowdedPlaces());
        }
    }
};

}  // namespace

Ptr<Problem> createHomographyProblem() { return makePtr<HomographyProblem>(); }

Ptr<NonMinimalSolver> createHomographyFit(const Ptr<Residual>& residual)
{
    return makePtr<LeastSquaresSolver<HomographyParameterization>>(residual, 2);
}

}  // namespace usacv20
}  // namespace cv
