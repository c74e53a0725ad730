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

//! Samples of a search for a pair, at least. Those that a right sample takes are not always enough:
//! its points may be near to each other. That many cost less than 2 ms.
enum { LEAST_SAMPLES = 500 };

//! A model of a pair and what it explains.
struct PairModel
{
    PairModel() : inliers(0) {}
    //! Is there one?
    explicit operator bool() const { return inliers > 0; }

    Matx33d matrix;
    Mat mask;     //!< of all matches
    int inliers;  //!< of these; 0: there is no model
    Report report;
};

//! The matches of a pair without distortion, and the searches for E, F and H among them.
class PairModels
{
public:
    //! Reads the arguments; raises cv::Exception for wrong ones.
    PairModels(const TwoViewPair& pair, const Params& params, const TwoViewRules& rules);

    //! All that is said at #estimateTwoViewGeometry, for pairs of at least leastMatches().
    void search();
    //! E, F or H, whichever tells the inliers; null: none of them was found.
    const PairModel* base() const;
    bool calibrated() const { return isCalibrated; }
    int size() const { return (int)points1.size(); }
    //! Pairs with less are refused at once: any seven matches have an F that fits.
    int leastMatches() const { return std::max(rules.minInliers, 8); }
    //! F of an E.
    Matx33d fundamental(const Matx33d& essential) const;
    //! On the image planes, z = 1, of the matches of a mask.
    void directions(const Mat& mask, std::vector<Vec3d>& first, std::vector<Vec3d>& second) const;
    //! Why there is no model.
    String reason() const;
    //! The rotation of the camera that explains the inliers of `explained`. @return false if there
    //! is none
    bool turn(const PairModel& explained, Matx33d& R) const;
    //! Do the inliers of H make a pair with these inliers planar or panoramic?
    bool mostlyOnPlane(const PairModel& inliers) const
    {
        return H.inliers > rules.planarRatio * inliers.inliers;
    }

    //! Within how many thresholds of the pair the errors of H in one image are, and the distances
    //! to H in both: the quantiles 0.95 of two degrees of freedom over that of one
    //! @cite hartley2003multiple (table 4.2), and two images.
    static double planarReach() { return std::sqrt(2 * 5.991 / 3.841); }
    static double planarDistance() { return std::sqrt(5.991 / 3.841); }

    PairModel E, F, H;
    Points points1, points2;  //!< pixels without distortion
    Matx33d camera1, camera2;
    const Params params;
    const TwoViewRules& rules;
    int iterations;  //!< of all models but H of inliers
    Report refused;  //!< of the best model that was refused
    bool cancelled;

private:
    void checkTaken(const Mat& given, const char* name) const;
    void searchEssential();
    void searchFundamental();
    //! Where F would tell that the focal lengths are wrong, the search of E may have missed what F
    //! has found: E starts from it.
    void improveEssential();
    void searchHomography();
    //! Of the matches that E or F explains. @param result the outcome of the search on entry, of
    //! the caller's images on return
    void homographyOfInliers(const PairModel& explained);
    Ptr<Usac> essential(const Params& options) const;
    Params options(int iterations) const;
    int samples(int sampleSize) const;
    //! What a search among all matches has found.
    void take(const ModelKind& kind, const Mat& matrix, const Mat& mask, const Report& report,
              PairModel& model);
    void account(const Report& report);
    void refuse(const ModelKind& kind, const Mat& matrix, int inliers, const Report& report);
    int withinDistances(const std::vector<double>& errors, double limit) const;

    bool isCalibrated;
    std::vector<float> scores;
    String why;  //!< the best model was refused
    String
        limited;  //!< models whose search the limit of the samples has ended before its confidence
};

}  // namespace usacv20
}  // namespace cv

#endif
