// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MOTION_FILES_HPP
#define OPENCV_USACV20_BENCHMARK_MOTION_FILES_HPP

#include "image_pair.hpp"
#include "truth_reader.hpp"

namespace benchmark {

//! Reads lines `X1 Y1 Z1 X2 Y2 Z2` into the points of both spaces. Raises std::runtime_error with
//! file and line if a line has another form.
void readSpacePoints(const std::string& file, ImagePair& pair);

/** Reads the true motion between two spaces. The points must have been read before. Raises
std::runtime_error with file and line if something is missing or wrong.
@param letter letter of the problem; it is an error if the member `problem` of the file excludes it
@param scaled false: a scale other than 1 is an error */
void readMotionTruth(const TruthReader& in, char letter, bool scaled, ImagePair& pair);

}  // namespace benchmark

#endif
