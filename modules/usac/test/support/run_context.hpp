// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RUN_CONTEXT_HPP
#define OPENCV_USACV20_TEST_RUN_CONTEXT_HPP

#include <vector>
#include "opencv2/usac.hpp"

namespace opencv_test {

//! Context of a run that has been started, with an arena of its own. The context keeps references
//! to the constructor's arguments.
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

//! Starts the component as in a run with these points and default parameters. @return the component
template <class T>
cv::Ptr<T> started(const cv::Ptr<T>& part, const cv::usacv20::Correspondences& points)
{
    const cv::usacv20::Components none;
    const cv::usacv20::Params params;
    part->start(RunContext(points, none, params));
    return part;
}

inline std::vector<cv::Vec2i> edgesOf(cv::usacv20::Neighborhood& neighborhood,
                                      const cv::usacv20::Context& context, const uchar* wanted = 0)
{
    const cv::Vec2i* edges = 0;
    const int count = neighborhood.edges(context, wanted, edges);
    return std::vector<cv::Vec2i>(edges, edges + count);
}

}  // namespace opencv_test

#endif
