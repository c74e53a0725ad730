// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_IMAGE_PAIR_HPP
#define OPENCV_USACV20_BENCHMARK_IMAGE_PAIR_HPP

#include <string>
#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac/params.hpp"

namespace benchmark {

using cv::usacv20::ProblemType;

//! The letter of a problem in names and tables: H homography; F, E fundamental and essential
//! matrix; A affinity, S similarity, T translation of the image; P absolute pose; R rigid motion, M
//! similarity of 3D space.
char letterOf(ProblemType problem);

//! Finds the problem of a letter. @return false for an unknown letter.
bool problemOf(char letter, ProblemType& problem);

/** Tentative correspondences with their ground truth: between two images, between object points and
one image (image 2), or between two point sets in space. */
struct ImagePair
{
    std::string name;
    std::vector<cv::Point2f> points1, points2;
    std::vector<cv::Point3f> objectPoints;  //!< P, R, M: used instead of points1
    std::vector<cv::Point3f> spacePoints2;  //!< R, M: used instead of points2
    std::vector<float> scores;              //!< one for each match, lower is better

    cv::Size2d size1, size2;
    bool hasHomography, hasCamera1, hasCamera2, hasPose;  //!< true if H; K1; K2; R and t are known
    cv::Matx33d H;                                        //!< image 1 -> image 2
    cv::Matx33d K1, K2;
    std::vector<double> distortion;  //!< P: distortion coefficients of calib3d; empty: none
    cv::Matx33d R;                   //!< point in camera 2 = R * point in camera 1 (P: object) + t
    cv::Vec3d t;                     //!< R and M: point of space 2 = scale R * point of space 1 + t
    double scale;            //!< problem M: scale of space 2 relative to space 1; otherwise 1
    std::vector<int> right;  //!< R, M: indices of the right matches; empty: unknown
    /** P: median depth of the right matches. R, M: size of the scene, the root mean square distance
    of the right points of space 2 from their mean. If it is unknown which matches are right, all
    matches are used. */
    double depth;
    std::vector<cv::Point2d> truth1, truth2;  //!< correspondences that are known to be right
    bool truthIsHomography;  //!< true: the true points of image 2 are H truth1, not truth2

    ImagePair()
        : hasHomography(false), hasCamera1(false), hasCamera2(false), hasPose(false), scale(1),
          depth(0), truthIsHomography(false)
    {}

    //! Number of correspondences.
    int size() const { return (int)(points2.size() + spacePoints2.size()); }
    //! Returns the matches in another order (match i of the result is match order[i]), with the
    //! camera matrices and the distortion, but without the scores and the ground truth.
    ImagePair reordered(const std::vector<int>& order) const;
};

/** Reads `<path>.corr` and `<path>.json`; for P, R and M, `<path>.txt`, `<path>.json` and, if it
exists, `<path>.score`. Raises std::runtime_error with the file and, where possible, the line if a
file cannot be read or lacks something that `problem` needs. */
ImagePair readImagePair(const std::string& path, ProblemType problem);

}  // namespace benchmark

#endif
