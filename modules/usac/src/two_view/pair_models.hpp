// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PAIR_MODELS_HPP
#define OPENCV_USACV20_PAIR_MODELS_HPP

#include "opencv2/usac/estimator.hpp"
#include "opencv2/usac/two_view_geometry.hpp"
#include "two_view/pixels.hpp"

namespace cv {
namespace usacv20 {

struct ModelKind;

//! Smallest result of TwoViewRules::samples(). This number of samples takes less than 2 ms. A
//! single all-inlier sample is not always enough, because its points may be close to each other.
enum { LEAST_SAMPLES = 500 };

//! A model of a pair of images and its inliers.
struct PairModel
{
    PairModel() : inliers(0) {}
    //! True if there is a model.
    explicit operator bool() const { return inliers > 0; }

    Matx33d matrix;
    Mat mask;     //!< marks the inliers among all matches
    int inliers;  //!< number of inliers; 0: there is no model
    Report report;
};

//! The undistorted matches of a pair, and the searches for E, F and H among them.
class PairModels
{
public:
    //! Reads the arguments. Raises cv::Exception if one of them is wrong.
    PairModels(const TwoViewPair& pair, const Params& params, const TwoViewRules& rules);

    //! Searches for E, F and H as described at #estimateTwoViewGeometry. The pair must have
    //! at least leastMatches() matches.
    void search();
    //! The model that determines the inliers of the pair: E, F or H. Null if none was found.
    const PairModel* base() const;
    bool calibrated() const { return isCalibrated; }
    int size() const { return (int)points1.size(); }
    //! Minimum number of matches of a pair, at least 8, because some F fits any seven matches.
    //! Pairs with fewer matches are rejected without a search.
    int leastMatches() const { return std::max(rules.minInliers, 8); }
    //! The fundamental matrix, of unit norm, that belongs to an essential matrix.
    Matx33d fundamental(const Matx33d& essential) const;
    //! Computes the viewing directions, with z = 1, of the matches that are marked in a mask.
    void directions(const Mat& mask, std::vector<Vec3d>& first, std::vector<Vec3d>& second) const;
    //! The mean threshold of the matches in pixels: Params::threshold, multiplied by the mean sigma
    //! if there are sigmas.
    double pixels() const;
    //! Describes why there is no model.
    String reason() const;
    //! Finds the rotation of a camera that has not translated, from the inliers of H. @return false
    //! if this rotation explains too few of the inliers of `explained`
    bool turn(const PairModel& explained, Matx33d& R) const;
    //! True if H has so many inliers, compared with a model, that the pair is planar or panoramic.
    //! @param inliers the model (E, F or H itself) with its inliers
    bool mostlyOnPlane(const PairModel& inliers) const
    {
        return H.inliers > rules.planarRatio * inliers.inliers;
    }

    //! Thresholds of H as multiples of the threshold of the pair: planarReach() for the error in
    //! one image, planarDistance() for the Sampson distance in both images. The square of
    //! planarDistance() is the ratio of the 0.95 quantiles of chi-square with two degrees of
    //! freedom and with one @cite hartley2003multiple (table 4.2). The square of planarReach() is
    //! twice this ratio, because the error in one image contains the noise of both images.
    static double planarReach() { return std::sqrt(2 * 5.991 / 3.841); }
    static double planarDistance() { return std::sqrt(5.991 / 3.841); }

    PairModel E, F, H;
    Points points1, points2;  //!< pixels without distortion
    Matx33d camera1, camera2;
    //! The options of the caller. With #THRESHOLD_ESTIMATED, the first accepted model sets the
    //! threshold of the pair, which all later searches use.
    Params params;
    const TwoViewRules& rules;
    int iterations;  //!< number of samples of all searches, except those of homographyOfInliers()
    Report refused;  //!< report of the rejected search with the lowest Report::chance
    bool cancelled;

private:
    void checkTaken(const Mat& given, const char* name) const;
    void searchEssential();
    void searchFundamental();
    //! Searches for E again, starting from F, in case the search for E has missed the best model.
    void improveEssential();
    void searchHomography();
    //! Searches for H among the inliers of E or F.
    void homographyOfInliers(const PairModel& explained);
    //! Of the two motions that explain the plane of H, makes E the one with the lower cost.
    void chooseMotion();
    Ptr<Usac> essential(const Params& options) const;
    Params options(int iterations) const;
    int samples(int sampleSize) const;
    //! Stores in `model` the result of a search among all matches, or rejects this result.
    void take(const ModelKind& kind, const Mat& matrix, const Mat& mask, const Report& report,
              PairModel& model);
    void account(const Report& report);
    //! Sets the threshold of the pair from the threshold of an accepted model, unless the threshold
    //! of the pair is already known.
    //! @param reach ratio of the threshold of the model to that of the pair
    void settle(const Report& report, double reach);
    void refuse(const ModelKind& kind, const Mat& matrix, int inliers, const Report& report);
    //! True if F has clearly more inliers than E. Then either the focal lengths are wrong, or the
    //! search for E has missed the best model, or F fits wrong matches that agree with each other.
    bool explainsMore() const;
    //! True if F shows that the focal lengths are wrong: F explains clearly more matches than E,
    //! and also nearly all matches that E explains, with errors that are hardly larger. (An F that
    //! fits wrong matches fits right ones worse.) If most inliers of E are on a plane,
    //! chanceOfEpipole() must also be small.
    bool contradictsCameras() const;
    /** Upper bound of the probability that F gains its additional matches by chance, if most
    inliers of E are on a plane: a plane does not determine the epipole, so that F can adapt to
    wrong matches. Only matches that neither E nor H explains count.

    Two of these matches determine the epipole of F if the plane is given. If F explains the others
    by chance, their errors are as dense just beyond the threshold as within it, even if wrong
    matches form clusters. Thus, each match with an error of up to BESIDE (three) thresholds is
    within one threshold with probability 1/3. The tail of this binomial distribution is multiplied
    by the number of pairs of matches that could have determined the epipole.
    @param ofE, ofF errors of all matches */
    double chanceOfEpipole(const std::vector<double>& ofE, const std::vector<double>& ofF) const;
    //! Sampson distances of all matches from F, in pixels or, if there are sigmas, as multiples of
    //! the sigma of each match.
    std::vector<double> errorsOf(const Matx33d& fundamental) const;
    int withinDistances(const std::vector<double>& errors, double limit) const;

    bool isCalibrated;
    double sigma;                       //!< Report::sigma of the model that set the threshold
    std::vector<float> scores, sigmas;  //!< of the pair or of the Params; can be empty
    String why;                         //!< why the search of `refused` gave no model
    String limited;  //!< text with the confidences of rejected searches that Params::maxIterations
                     //!< ended before they reached the requested confidence
};

}  // namespace usacv20
}  // namespace cv

#endif
