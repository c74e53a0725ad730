// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RUN_CONTEXT_HPP
#define OPENCV_USACV20_TEST_RUN_CONTEXT_HPP

#include <vector>
#include "opencv2/usac.hpp"

namespace opencv_test {

//! A run that has begun, with memory of its own. It keeps what it is given by reference.
class RunContext
{
public:
    RunContext(const cv::usacv20::Correspondences& points, const cv::usacv20::Components& parts,
               const cv::usacv20::Params& params)
        : context(points, parts, params, arena)
    {
        parts.start(context);
    }

    operator const cv::usacv20::Context&() const { return context; }

private:
    cv::usacv20::Arena arena;

public:
    const cv::usacv20::Context context;

private:
    RunContext(const RunContext&);
    RunContext& operator=(const RunContext&);
};

//! The same component, which a run has begun with such points.
template <class T>
cv::Ptr<T> started(const cv::Ptr<T>& part, const cv::usacv20::Correspondences& points)
{
    const cv::usacv20::Components none;
    const cv::usacv20::Params params;
    part->start(RunContext(points, none, params));
    return part;
}

inline std::vector<cv::Vec2i> edgesOf(cv::usacv20::Neighborhood& neighborhood,
                                      const cv::usacv20::Context& context)
{
    const cv::Vec2i* edges = 0;
    const int count = neighborhood.edges(context, edges);
    return std::vector<cv::Vec2i>(edges, edges + count);
}

}  // namespace opencv_test

#endif
