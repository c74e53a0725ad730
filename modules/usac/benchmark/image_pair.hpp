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

//! The letter of a problem in names and tables, see problemLetters().
char letterOf(ProblemType problem);

//! The problem of a letter. @return false for any other letter.
bool problemOf(char letter, ProblemType& problem);

/** Tentative correspondences and the truth about them: of two images, of object points and one
image, which is image 2 then, or of two spaces. */
struct ImagePair
{
    std::string name;
    std::vector<cv::Point2f> points1, points2;
    std::vector<cv::Point3f> objectPoints;  //!< P, R, M: in the place of points1
    std::vector<cv::Point3f> spacePoints2;  //!< R, M: in the place of points2
    std::vector<float> scores;              //!< one a correspondence, lower is better

    cv::Size2d size1, size2;
    bool hasHomography, hasCamera1, hasCamera2, hasPose;  //!< which of the matrices below are known
    cv::Matx33d H;                                        //!< image 1 -> image 2
    cv::Matx33d K1, K2;
    std::vector<double> distortion;  //!< P: coefficients of calib3d; empty: none
    cv::Matx33d R;                   //!< x2 ~ R x1 + t; R, M: X2 = scale R X1 + t
    cv::Vec3d t;
    double scale;            //!< M: of space 2 to space 1; else 1
    std::vector<int> right;  //!< R, M: the right matches; empty: it is not known which are right
    /** P: depth of the scene, median over the right matches. R, M: its size, root of the mean
    squared distance of the right points of space 2 from their mean. */
    double depth;
    std::vector<cv::Point2d> truth1, truth2;  //!< correspondences that are known to be right
    bool truthIsHomography;                   //!< errors are measured against H, not against truth2

    ImagePair()
        : hasHomography(false), hasCamera1(false), hasCamera2(false), hasPose(false), scale(1),
          depth(0), truthIsHomography(false)
    {}

    //! Number of the correspondences.
    int size() const { return (int)(points2.size() + spacePoints2.size()); }
    //! The correspondences in another order, with the cameras, without the truth.
    ImagePair reordered(const std::vector<int>& order) const;
};

/** Reads `<path>.corr` and `<path>.json`, for P, R and M `<path>.txt`, `<path>.score` and
`<path>.json`. Whatever `problem` needs and the files lack raises std::runtime_error with file and
line. */
ImagePair readImagePair(const std::string& path, ProblemType problem);

}  // namespace benchmark

#endif
