// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problem_data.hpp"
#include "run_memory.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Bytes per point: 88 for the points themselves and 150 for temporary data, mostly of polishing
and significance. Bytes per point of the search: 62 for order and graph, 28 for sampler and checks,
and 24 to spare. Bytes per run: batches, runners-up and tables; the search for planes. Bytes for
threads: the hypotheses of a batch, at most. Too small a value only costs another block; memory that
is not written to costs nothing. */
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
