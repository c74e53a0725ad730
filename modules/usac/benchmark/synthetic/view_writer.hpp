// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_VIEW_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_VIEW_WRITER_HPP

#include "list_writer.hpp"
#include "view_scene.hpp"

namespace benchmark {

/** Writes views of object points as a data set of the benchmark for P: `.txt`, `.score` and `.json`
for each view, see ListWriter. */
class ViewWriter
{
public:
    ViewWriter(const std::string& folder, const std::string& name);

    void write(const ViewScene& scene);

private:
    ListWriter list;
};

}  // namespace benchmark

#endif
