// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_VIEW_FILES_HPP
#define OPENCV_USACV20_BENCHMARK_VIEW_FILES_HPP

#include "image_pair.hpp"
#include "truth_reader.hpp"

namespace benchmark {

//! Reads lines `X Y Z u v` into the object points and the points of image 2. Raises
//! std::runtime_error with file and line if a line has another form.
void readObjectPoints(const std::string& file, ImagePair& pair);

//! Reads the scores of all matches, one on each line. If there is no such file, all scores are 1.
void readScores(const std::string& file, ImagePair& pair);

//! Reads an array of indices of matches into an empty vector, which stays empty if the value is
//! `null`. @param size number of matches
void readIndices(const Json& json, int size, std::vector<int>& indices);

//! Reads the camera and its true pose. The points must have been read before. Raises
//! std::runtime_error if something is missing or wrong, or if the member `problem` of the file
//! excludes the problem `letter`.
void readViewTruth(const TruthReader& in, char letter, ImagePair& pair);

}  // namespace benchmark

#endif
