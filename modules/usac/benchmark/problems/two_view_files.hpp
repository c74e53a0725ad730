// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TWO_VIEW_FILES_HPP
#define OPENCV_USACV20_BENCHMARK_TWO_VIEW_FILES_HPP

#include "image_pair.hpp"
#include "truth_reader.hpp"

namespace benchmark {

//! Reads lines `x1 y1 x2 y2 score`; a score that is missing is set to 1. Raises std::runtime_error
//! with file and line if a line has another form.
void readCorrespondences(const std::string& file, ImagePair& pair);

//! Reads the ground truth of an image pair. Raises std::runtime_error if the file has a wrong form,
//! or if its member `problem` excludes the problem `letter`.
void readTwoViewTruth(const TruthReader& in, char letter, ImagePair& pair);

//! Raises an exception if the error of a model cannot be measured, because true points are missing,
//! or because H is missing although the file says that H is the ground truth.
void checkTruePoints(const TruthReader& in, const ImagePair& pair);

}  // namespace benchmark

#endif
