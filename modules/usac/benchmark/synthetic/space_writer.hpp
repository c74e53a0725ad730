// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SPACE_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_SPACE_WRITER_HPP

#include "list_writer.hpp"
#include "space_scene.hpp"

namespace benchmark {

/** Writes pairs of point clouds as a data set of the benchmark for R or M: `.txt`, `.score` and
`.json` for each pair, see ListWriter. */
class SpaceWriter
{
public:
    //! @param letter "R" or "M"
    SpaceWriter(const std::string& folder, const std::string& name, const std::string& letter);

    void write(const SpaceScene& scene);

private:
    void writeTruth(const std::string& file, const SpaceScene& scene) const;

    std::string letter;
    ListWriter list;
};

}  // namespace benchmark

#endif
