// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "run_memory.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Bytes. Of a point: the points themselves 88, order and graph 62, what sampler and checks know of
it 28, and what is needed for a while, most by polishing and significance, 150. Of a run: batches,
runners-up, tables; the search for planes. Of a thread: its part of the hypotheses of a batch, at
most. Too little costs another block and nothing else; what is not written to costs nothing. */
constexpr size_t OF_POINT = 352, OF_RUN = 64 << 10, OF_PLANES = 64 << 10, OF_BATCH = 512 << 10;

}  // namespace

size_t runMemory(int points, const Params& params)
{
    size_t bytes = (size_t)points * OF_POINT + OF_RUN;
    if (params.degeneracy & DEGENERACY_DEGENSAC)
        bytes += OF_PLANES;
    if (params.threads != 1)
        bytes += OF_BATCH;
    return bytes;
}

}  // namespace usacv20
}  // namespace cv
