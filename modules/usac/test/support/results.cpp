// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/results.hpp"

namespace opencv_test {

Hash& Hash::add(const void* data, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        state = (state ^ static_cast<const uchar*>(data)[i]) * 0x100000001b3ULL;
    return *this;
}

Hash& Hash::add(const Mat& mat)
{
    number(mat.rows).number(mat.cols);
    for (int i = 0; i < mat.rows; ++i)
        add(mat.ptr(i), mat.cols * mat.elemSize());
    return *this;
}

uint64 Result::exact() const
{
    const Report& r = report;
    const int counts[] = {r.stop,
                          r.iterations,
                          r.rejectedSamples,
                          r.degenerateSamples,
                          r.models,
                          r.rejectedModels,
                          r.refusedModels,
                          r.droppedModels,
                          r.localOptimizations,
                          r.localImprovements,
                          r.degenerate,
                          r.inliers,
                          r.independentInliers};
    return Hash()
        .add(model)
        .add(mask)
        .add(counts, sizeof(counts))
        .number(r.chance)
        .number(r.threshold)
        .number(r.cost)
        .value();
}

uint64 Result::robust() const
{
    return Hash().add(mask).number(report.iterations).number(report.stop).value();
}

Result resultOf(const Scene& scene, const Params& params)
{
    Result result;
    result.model = estimate(scene, params, result.mask, &result.report);
    return result;
}

}  // namespace opencv_test
