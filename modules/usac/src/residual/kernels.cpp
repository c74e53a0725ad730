// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "numeric/instruction_set.hpp"

namespace cv {
namespace usacv20 {

void toFloat(const Model& model, float* m, bool homogeneous)
{
    double factor = 1, limit = FLT_MAX;
    if (homogeneous)
    {
        double largest = 0;
        for (int i = 0; i < model.size(); ++i)
            largest = std::max(largest, std::abs(model.val[i]));
        factor = largest > 0 ? 1 / largest : 0;
        limit = 1;
    }
    float all[MAX_MODEL_SIZE];
    USAC_SIMD
    for (int i = 0; i < MAX_MODEL_SIZE; ++i)
    {
        const double value = model.val[i] * factor, raised = value < -limit ? -limit : value;
        all[i] = (float)(limit < raised ? limit : raised);
    }
    std::copy(all, all + model.size(), m);
}

}  // namespace usacv20
}  // namespace cv
