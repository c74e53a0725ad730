// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROBLEM_DATA_HPP
#define OPENCV_USACV20_PROBLEM_DATA_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** Reads the caller's arrays once and stores them in two forms: all rows in their original order
(as double, for the final mask), and the rows without NaN and infinite numbers as Correspondences,
that is, normalized, shuffled and as a structure of arrays. Takes O(N) memory and time. */
class ProblemData
{
public:
    /** Maximum number of points in the search. If there are more points, the search uses a random
    subset of this size. A subset of this size yields the inlier ratio with a standard deviation of
    at most 0.3 percentage points, and thus distinguishes models whose ratios differ by clearly
    more than that. The number is a multiple of 16. */
    enum { SEARCHED = 1 << 15 };

    //! Holds no points.
    ProblemData();

    /** @brief Reads new points.
    @param problem must outlive this object
    @param points1, points2, params as in Usac::create; after a cv::Exception the object holds no
    points
    @param arena memory; it is reset to a size sufficient for a run, and the points are stored there
    @param image true: the original image points are stored, too, for Problem::createImageResidual
    */
    void read(const Problem& problem, InputArray points1, InputArray points2, const Params& params,
              Arena& arena, bool image);

    //! The usable points, see useRepetitions().
    const Correspondences& points() const { return view; }
    //! True: points() contains all usable points. False, as after read(): unless Params::degeneracy
    //! lacks #DEGENERACY_REPEATED, it contains each frequent match only once.
    void useRepetitions(bool use) { view.size = use ? usable : different; }
    /** The points of the search: the first #SEARCHED of points(), which are in random order. They
    are enough to find the best model; polishing then uses all points to make this model accurate.
    */
    const Correspondences& searchPoints() const { return part; }
    //! points() with the original image points, for the residual of Problem::createImageResidual.
    Correspondences imagePoints() const;

    //! The threshold of the mask in the unit of Params::threshold.
    double threshold() const { return pixelThreshold; }
    //! Sets the thresholds of search and mask for the rest of the run. `threshold` is in the
    //! coordinates of points(). If it is the present threshold of the search, nothing changes.
    void setThreshold(double threshold);
    //! Sets the thresholds of search and mask to `factor` times their values before the run. The
    //! search threshold has a lower bound.
    void scaleThreshold(double factor);
    //! Restores the thresholds and the reach after a run, which may have changed them.
    void restoreThreshold();
    //! The reach, that is, the ratio of the search threshold to the mask threshold. Its initial
    //! value is Params::reach.
    double reach() const { return currentReach; }
    //! Sets the reach for the rest of the run and changes the search threshold accordingly.
    void setReach(double reach)
    {
        setSearchThreshold(view.threshold * (reach / currentReach));
        currentReach = reach;
    }
    //! Writes to `mask`, for each of the caller's rows, 1 if its error is at most the threshold,
    //! and 0 otherwise. The model is in the coordinates of Problem::toModelCoordinates. If `image`
    //! is true, the original image points are used.
    //! @return number of inliers.
    int mask(const Residual& residual, const Model& model, bool image, uchar* mask) const;
    //! The errors of all of the caller's rows, in the unit of Params::threshold, not squared;
    //! mask() compares them with threshold().
    void errors(const Residual& residual, const Model& model, bool image, double* distances) const;
    //! The threshold of the mask, in the coordinates of points().
    double maskThreshold() const { return inputThreshold * view.frame[1].scale; }
    /** Fills the fields of a report that describe the mask, except Report::inliers, which must be
    set already, like Report::stop.
    @param independent also count the independent inliers, which takes some time */
    void tell(const uchar* mask, bool independent, Arena& arena, Report& report) const;

private:
    //! True if the threshold of the mask is wide, see Report::wideThreshold; false without points.
    bool wideThreshold() const;
    //! Number of inliers, where inliers at nearly the same position in one of the arrays count
    //! once, see usacv20::independentInliers and Problem::commonUnit.
    int independentInliers(const uchar* mask, Arena& arena) const;
    void setSearchThreshold(double threshold) { view.threshold = part.threshold = threshold; }
    void readRows(InputArray points1, InputArray points2, const Params& params, Arena& arena);
    void checkNoise(const Params& params, int count);
    void readNoise(const Params& params, Arena& arena);
    bool usableRow(int row) const;
    void scale(const Params& params, Arena& arena);
    void scaleColumn(int k, double shift, double factor);
    //! The same as the public errors() for `count` rows, beginning with the row `first`.
    void errors(const Residual& residual, const Model& model, bool image, int first, int count,
                double* distances) const;
    int usableRows(int* rows) const;
    void shuffle(const Params& params, Arena& arena);
    void keepImage(const Params& params, Arena& arena);
    void shuffleImage(Arena& arena);

    Correspondences view, part;
    double givenThreshold[3];  //!< view.threshold, inputThreshold and pixelThreshold before the run
    double givenReach, currentReach;
    double inputThreshold;         //!< threshold of the mask in the coordinates of `input`
    double pixelThreshold;         //!< threshold of the mask in the unit of Params::threshold
    double pixels;                 //!< number of units of Params::threshold per unit of `input`
    double* input[MAX_COLUMNS];    //!< columns with all rows (E: on the normalized image plane)
    double* doubles[MAX_COLUMNS];  //!< columns of Correspondences
    float* floats[MAX_COLUMNS];
    double* seen[MAX_COLUMNS];  //!< all rows of the original image points (second array), then the
                                //!< noise of the matches; null: not stored
    const double* seenDoubles[MAX_COLUMNS];  //!< `seen`, shuffled and normalized, for imagePoints()
    const float* seenFloats[MAX_COLUMNS];
    String doubt;           //!< of Problem::doubt
    int usable, different;  //!< numbers of points with and without repetitions of frequent matches
    int described;  //!< number of matches in the arrays read last, which Params::sigmas, if there
                    //!< are any, describe; 0: no points were read

    ProblemData(const ProblemData&);
    ProblemData& operator=(const ProblemData&);
};

//! The model for the mask, in the coordinates of Problem::toModelCoordinates: the returned matrix,
//! converted by Problem::ofOutput, or `model` if the problem has no such conversion.
inline Model modelOfMask(const Problem& problem, const Mat& returned, const Model& model)
{
    const Model exact = problem.ofOutput(returned);
    return exact.size() > 0 ? exact : model;
}

}  // namespace usacv20
}  // namespace cv

#endif
