// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_VIEW_FILES_HPP
#define OPENCV_USACV20_BENCHMARK_VIEW_FILES_HPP

#include "image_pair.hpp"
#include "truth_reader.hpp"

namespace benchmark {

//! Reads `X Y Z u v` lines into the object points and the points of image 2. Raises
//! std::runtime_error with file and line, as all here.
void readObjectPoints(const std::string& file, ImagePair& pair);

//! Reads a score a line, one for each match; where there is no such file, all are 1.
void readScores(const std::string& file, ImagePair& pair);

//! Reads numbers of matches; null: none.
void readIndices(const Json& json, int size, std::vector<int>& indices);

//! Reads what is known of the camera and of its pose, behind the points.
void readViewTruth(const TruthReader& in, char letter, ImagePair& pair);

}  // namespace benchmark

#endif
