// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_GIVEN_EDGES_HPP
#define OPENCV_USACV20_TEST_GIVEN_EDGES_HPP

#include "test_precomp.hpp"

namespace opencv_test {

//! A neighborhood graph whose edges are set by the test. It has no layers (sizes of neighborhoods),
//! because the graph cut uses only the edges.
class GivenEdges : public Neighborhood
{
public:
    int layers() const CV_OVERRIDE { return 0; }
    int members(const Context&, int, int, const int*&) CV_OVERRIDE { return 0; }
    int edges(const Context&, const uchar*, const Vec2i*& edges) CV_OVERRIDE
    {
        edges = given.data();
        return (int)given.size();
    }

    int mostEdges() const CV_OVERRIDE { return most; }

    std::vector<Vec2i> given;
    int most = -1;  //!< result of mostEdges()
};

}  // namespace opencv_test

#endif
