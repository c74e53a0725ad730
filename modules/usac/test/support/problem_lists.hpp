// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PROBLEM_LISTS_HPP
#define OPENCV_USACV20_TEST_PROBLEM_LISTS_HPP

#include "opencv2/usac.hpp"

// Lists of problems, generated from registry.inl.hpp.

namespace opencv_test {

#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) cv::usacv20::TYPE,
const int ALL_PROBLEMS[] = {
#include "problems/registry.inl.hpp"
};

//! Problems of matches between two images.
const int TWO_VIEW_PROBLEMS[] = {
#define USACV20_IMAGES(TYPE) cv::usacv20::TYPE,
#define USACV20_CAMERAS(TYPE) cv::usacv20::TYPE,
#define USACV20_POSE(TYPE)
#define USACV20_SPACES(TYPE)
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) USACV20_##ARGUMENTS(TYPE)
#include "problems/registry.inl.hpp"
};

//! Problems of pairs of 3-D points.
const int SPACE_PROBLEMS[] = {
#define USACV20_IMAGES(TYPE)
#define USACV20_CAMERAS(TYPE)
#define USACV20_POSE(TYPE)
#define USACV20_SPACES(TYPE) cv::usacv20::TYPE,
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) USACV20_##ARGUMENTS(TYPE)
#include "problems/registry.inl.hpp"
};

//! Problems for which a function of OpenCV accepts the module's flags.
const int FLAG_PROBLEMS[] = {cv::usacv20::HOMOGRAPHY, cv::usacv20::FUNDAMENTAL,
                             cv::usacv20::ESSENTIAL, cv::usacv20::AFFINITY,
                             cv::usacv20::SIMILARITY};
//! True if the problem is one of FLAG_PROBLEMS.
bool hasFlags(cv::usacv20::ProblemType problem);

//! Number of points in a minimal sample of the problem.
int sampleSizeOf(int problem);

}  // namespace opencv_test

#endif
