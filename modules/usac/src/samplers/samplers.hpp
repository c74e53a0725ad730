// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SAMPLERS_HPP
#define OPENCV_USACV20_SAMPLERS_HPP

#include "opencv2/usac/components.hpp"
#include "samplers/growth.hpp"

namespace cv {
namespace usacv20 {

//! Of four samples of P-NAPSAC of points in a known order one is local and three are PROSAC's.
const double PROSAC_SHARE = 0.75;

//! All samples equally likely, see UniformSampler.
Ptr<Sampler> createUniformSampler();
//! The best points first, see ProsacSampler.
Ptr<Sampler> createProsacSampler();
//! Neighbours of the best points first, see PNapsacSampler.
Ptr<Sampler> createPNapsacSampler();
//! Neighbours of any point, see NapsacSampler.
Ptr<Sampler> createNapsacSampler();
//! Points as often as their scores say, see ImportanceSampler.
Ptr<Sampler> createImportanceSampler();

//! Fills places 1 .. m-1 of a sample with distinct points other than sample[0]. `members` are `count` >= m, sample[0] among them.
inline void drawOthers(Rng& rng, const int* members, int count, int m, int* sample)
{
    for (int k = 1; k < m;)
    {
        sample[k] = members[rng.uniform(count)];
        int j = 0;
        while (sample[j] != sample[k])
            ++j;
        k += j == k;
    }
}

} // namespace usacv20
} // namespace cv

#endif
