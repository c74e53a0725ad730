// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLES_MATCHES_FILE_HPP
#define OPENCV_USACV20_SAMPLES_MATCHES_FILE_HPP

#include <fstream>
#include <sstream>
#include <string>
#include <vector>
#include "opencv2/core.hpp"

//! Reads a text file with a row "x1 y1 x2 y2" for each match and appends the points to the lists.
//! Further text in a row is ignored, and so are rows without four numbers.
inline void readMatches(const std::string& file, std::vector<cv::Point2d>& points1,
                        std::vector<cv::Point2d>& points2)
{
    std::ifstream in(file.c_str());
    if (!in)
        CV_Error(cv::Error::StsObjectNotFound, file + " cannot be read");
    std::string line;
    while (std::getline(in, line))
    {
        std::istringstream row(line);
        cv::Point2d p1, p2;
        if (row >> p1.x >> p1.y >> p2.x >> p2.y)
        {
            points1.push_back(p1);
            points2.push_back(p2);
        }
    }
}

#endif
