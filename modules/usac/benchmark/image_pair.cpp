// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "image_pair.hpp"

#include "problems/problem_kind.hpp"

namespace benchmark {

namespace {

template <class Element>
std::vector<Element> inOrder(const std::vector<Element>& elements, const std::vector<int>& order)
{
    std::vector<Element> result(elements.empty() ? 0 : order.size());
    for (size_t i = 0; i < result.size(); ++i)
        result[i] = elements[order[i]];
    return result;
}

}  // namespace

ImagePair ImagePair::reordered(const std::vector<int>& order) const
{
    ImagePair result;
    result.points1 = inOrder(points1, order);
    result.points2 = inOrder(points2, order);
    result.objectPoints = inOrder(objectPoints, order);
    result.spacePoints2 = inOrder(spacePoints2, order);
    result.K1 = K1;
    result.K2 = K2;
    result.distortion = distortion;
    return result;
}

ImagePair readImagePair(const std::string& path, ProblemType problem)
{
    ImagePair pair;
    pair.name = path.substr(path.find_last_of("/\\") + 1);
    kindOf(problem).read(path, pair);
    return pair;
}

}  // namespace benchmark
