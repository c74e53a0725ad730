// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PAIR_LIST_HPP
#define OPENCV_USACV20_BENCHMARK_PAIR_LIST_HPP

#include <string>
#include <vector>
#include "image_pair.hpp"

namespace benchmark {

/** A list of image pairs. Each line of the file has the path of a pair without extension. Empty
lines and lines that start with # are skipped.

Relative paths refer to the folder of the list, or to the parent of this folder if it is called
`lists`. A letter in the file name determines the problem: `<dataset>.H.list`, `<dataset>.F.list`
and so on.
*/
struct PairList
{
    struct Entry
    {
        std::string path;  //!< path of the pair, without extension
        int line;          //!< line number in the list file
    };

    std::string file;
    std::string name;  //!< name of the data set
    ProblemType problem;
    std::vector<Entry> entries;
};

/** Reads a list. @param letter the problem, or '\0' to take the letter from the file name.
Raises std::runtime_error if the file cannot be read, or if there is no letter of a problem. */
PairList readPairList(const std::string& file, char letter);

//! The files `<folder>/lists/*.H.list` and so on, in the order of problemLetters(). @param letter
//! the problem of the lists; '\0' for the lists of all problems.
std::vector<std::string> findLists(const std::string& folder, char letter);

}  // namespace benchmark

#endif
