// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MATCH_NOISE_HPP
#define OPENCV_USACV20_MATCH_NOISE_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** The noise of matches, Params::sigmas. Each match has one number, its sigma; or three, the
covariance of its point in the last array; or six, this covariance and that of its point in the
first array. A covariance is given as its upper triangle xx, xy, yy. */
class MatchNoise
{
public:
    //! Correspondences::noise for N = `count` matches: 0 without sigmas, 1 for N sigmas. For 3 N or
    //! 6 N numbers, it is 6 if both arrays are images, otherwise 3. Raises cv::Exception if the
    //! problem does not support one or two covariances per match.
    static int columnsOf(const Problem& problem, const std::vector<float>& sigmas, int count);

    //! @param sigmas_ Params::sigmas, not empty
    MatchNoise(const Problem& problem_, const std::vector<float>& sigmas_, int count_);

    //! Correspondences::meanSigma.
    double mean() const { return unit; }
    //! Standard deviation of the noise of a match; if the match has covariances, that of the
    //! isotropic noise that gives its error about the same variance as these covariances.
    double sigma(int match) const;

    /** @brief Computes the columns that describe the noise in the coordinates of the model.
    @param taken all columns of points as given, not yet converted by
    Problem::toModelCoordinates
    @param image true: for the coordinates of Problem::toImageCoordinates
    @param noise output, columnsOf() columns, see Correspondences */
    void toColumns(const double* const* taken, bool image, double* const* noise,
                   Arena& arena) const;

private:
    double variance(int match) const;
    void readRoots(int first, double* const* root) const;
    void transform(const double* const* taken, bool image, bool both, double* const* noise,
                   Arena& arena) const;
    double convert(double* const* columns, int points, bool image) const;

    const Problem& problem;
    const std::vector<float>& sigmas;
    const int count, each;  //!< number of matches; how many of the sigmas describe one match
    double unit;            //!< mean()
};

}  // namespace usacv20
}  // namespace cv

#endif
