// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/problem_data.hpp"
#include "input/run_memory.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Numbers of bytes. OF_POINT, for each point: 88 for the point itself and 150 for temporary data,
mostly of polishing and significance. OF_SEARCH, for each point of the search: 62 for order and
graph, 28 for sampler and checks, and 24 to spare. OF_RUN: batches, runners-up and tables.
OF_PLANES: the search for planes. OF_BATCH, with several threads: the hypotheses of the largest
batch. Too small a value only costs another block; memory that is not written to costs nothing. */
constexpr size_t OF_POINT = 238, OF_SEARCH = 114, OF_RUN = 64 << 10, OF_PLANES = 64 << 10,
                 OF_BATCH = 512 << 10;

}  // namespace

size_t runMemory(int points, const Params& params)
{
    size_t bytes = (size_t)points * OF_POINT +
                   std::min<int>(points, ProblemData::SEARCHED) * OF_SEARCH + OF_RUN;
    if (params.degeneracy & DEGENERACY_DEGENSAC)
        bytes += OF_PLANES;
    if (params.threads != 1)
        bytes += OF_BATCH;
    return bytes;
}

}  // namespace usacv20
}  // namespace cv
