// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MOTION_FILES_HPP
#define OPENCV_USACV20_BENCHMARK_MOTION_FILES_HPP

#include "image_pair.hpp"
#include "truth_reader.hpp"

namespace benchmark {

//! Reads `X1 Y1 Z1 X2 Y2 Z2` lines into the points of both spaces. Raises std::runtime_error with
//! file and line, as all here.
void readSpacePoints(const std::string& file, ImagePair& pair);

/** Reads what is known of the motion between two spaces, behind the points.
@param scaled whether the motion may have a scale other than 1 */
void readMotionTruth(const TruthReader& in, char letter, bool scaled, ImagePair& pair);

}  // namespace benchmark

#endif
