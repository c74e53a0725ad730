// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PROBLEM_DATA_HPP
#define OPENCV_USACV20_PROBLEM_DATA_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** Reads the caller's arrays once and keeps them in two forms: all rows as given (double, for the
final mask) and the finite ones scaled, shuffled and as structure of arrays (Correspondences). O(N)
memory and time. */
class ProblemData
{
public:
    //! Of no points.
    ProblemData();

    /** @brief Other points.
    @param problem must outlive this object
    @param points1, points2, params as Usac::create takes them; if there is a mistake, there are no
    points
    @param arena memory, which is freed before and has room for a run then; what is read stays there
    @param image also as they were seen, see Problem::createImageResidual */
    void read(const Problem& problem, InputArray points1, InputArray points2, const Params& params,
              Arena& arena, bool image);

    const Correspondences& points() const { return view; }
    //! The same as they were seen: for the residual of Problem::createImageResidual.
    Correspondences imagePoints() const;

    //! In pixels.
    double threshold() const { return pixelThreshold; }
    //! Another one for the rest of the run, in the coordinates of points().
    void setThreshold(double threshold);
    //! That of before the run, which may have changed it.
    void restoreThreshold();
    //! So many times as large a Correspondences::threshold for the rest of the run; the mask has
    //! that of before.
    void scaleReach(double factor) { view.threshold *= factor; }
    //! Mask of the rows with error <= threshold under a model in the caller's coordinates. `image`:
    //! as they were seen.
    //! @return number of ones.
    int mask(const Residual& residual, const Model& model, bool image, uchar* mask,
             Arena& arena) const;
    //! The errors of all rows, in the unit of threshold(): what the mask compares with it.
    void errors(const Residual& residual, const Model& model, bool image, double* errors) const;
    //! Of the mask, in the coordinates of points().
    double maskThreshold() const { return inputThreshold * view.frame[1].scale; }
    /** What a report tells of the mask, but Report::inliers, which it has already.
    @param independent also how many inliers are independent, which takes some time */
    void tell(const uchar* mask, bool independent, Arena& arena, Report& report) const;

private:
    //! Report::wideThreshold of the mask.
    bool wideThreshold() const;
    //! Those of a mask that are not the same as another one in either array, see
    //! Problem::commonUnit.
    int independentInliers(const uchar* mask, Arena& arena) const;
    void readRows(InputArray points1, InputArray points2, const Params& params, Arena& arena);
    bool finiteRow(int row) const;
    void scale(const Params& params, Arena& arena);
    void scaleColumn(int k, double shift, double factor);
    void shuffle(const Params& params, Arena& arena);
    void keepImage(Arena& arena);
    void shuffleImage(Arena& arena);

    Correspondences view;
    double givenThreshold[3];      //!< that of points(), of the mask and in pixels before the run
    double inputThreshold;         //!< of the mask, in the coordinates of `input`
    double pixelThreshold;         //!< the same in pixels
    double pixels;                 //!< in one unit of `input`
    double* input[MAX_COLUMNS];    //!< all rows, a column each (E: on the normalized image plane)
    double* doubles[MAX_COLUMNS];  //!< those of Correspondences
    float* floats[MAX_COLUMNS];
    double*
        seen[3];  //!< points of the last array as they were seen: all rows; null if not asked for
    const double* seenDoubles[3];  //!< those of imagePoints()
    const float* seenFloats[3];

    ProblemData(const ProblemData&);
    ProblemData& operator=(const ProblemData&);
};

//! The model of the mask: the one that is returned, to the bit, if the problem reads it back; else
//! `model`.
inline Model modelOfMask(const Problem& problem, const Mat& returned, const Model& model)
{
    const Model exact = problem.ofOutput(returned);
    return exact.size() > 0 ? exact : model;
}

}  // namespace usacv20
}  // namespace cv

#endif
