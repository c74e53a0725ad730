// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_CONTRACTS_HPP
#define OPENCV_USACV20_TEST_CONTRACTS_HPP

// Functions shared by contracts/, api/ and some of the other tests, defined in contracts.cpp.

#include "test_precomp.hpp"
#include "support/result_oracle.hpp"

namespace opencv_test {

//! Name of a problem, for messages of failing tests.
const char* nameOf(ProblemType problem);

//! Camera matrix of all scenes of makeScene().
Matx33d sceneCamera();

//! Calls the estimate function of the problem; K is used for E and absolute pose only.
Mat estimatePoints(ProblemType problem, InputArray points1, InputArray points2,
                   const Params& params, OutputArray mask, Report& report,
                   InputArray K = sceneCamera());

//! Packs the scene and the parameters for the oracle brokenResult().
EstimatorCall callOf(const Scene& scene, const Params& params);

//! Checks the documented properties of a result for the standard residual and a threshold of
//! `pixels`. If `widestReach` (Params::widestReach) is above 1, a model without inliers is
//! accepted. The second form is for points and a camera matrix that are not those of a Scene.
void checkResult(const Scene& scene, double pixels, const Mat& model, const Mat& mask,
                 const Report& report, double widestReach = 1);
void checkResult(ProblemType problem, const std::vector<Point2d>& points1,
                 const std::vector<Point2d>& points2, double pixels, const Mat& model,
                 const Mat& mask, const Report& report, const Matx33d& K = sceneCamera(),
                 double widestReach = 1);

struct NamedPreset
{
    const char* name;
    Params params;
};

std::vector<NamedPreset> allPresets();
//! Like allPresets(). For problems other than H, F and E, the only degeneracy check of usac2013()
//! and paper() is DEGENERACY_REPEATED, because DEGENSAC raises an exception for these problems.
std::vector<NamedPreset> allPresets(ProblemType problem);

/** Runs every preset on the points, both with the estimate function and with Usac::create, and
every flag with the find functions (if the problem has flags). Expects no exception, bitwise
identical results of all ways to run the same preset, and results with all documented properties
(checkResult).
@return the models of the presets */
std::vector<Mat> checkEveryWay(ProblemType problem, const std::vector<Point2d>& points1,
                               const std::vector<Point2d>& points2, double pixels = 1.5,
                               int maxIterations = 200, const Matx33d& K = sceneCamera());

//! Returns true if type, size and all bits of the elements are equal, or if both are empty.
bool sameBits(const Mat& a, const Mat& b);

//! Runs `call`, which has to raise a cv::Exception with `words` in its message.
template <class Call>
void expectException(const Call& call, const std::string& words)
{
    try
    {
        call();
        ADD_FAILURE() << "no exception, expected one about: " << words;
    }
    catch (const cv::Exception& e)
    {
        EXPECT_NE(std::string::npos, std::string(e.what()).find(words))
            << e.what() << " does not name " << words;
    }
}

//! A test that is run once for each problem; its parameter is a ProblemType.
class UsacProblem : public testing::TestWithParam<int>
{
protected:
    ProblemType problem() const { return (ProblemType)GetParam(); }
};

}  // namespace opencv_test

#endif
