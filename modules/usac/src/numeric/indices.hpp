// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INDICES_HPP
#define OPENCV_USACV20_INDICES_HPP

namespace cv {
namespace usacv20 {

//! A list of indices at compile time, like std::index_sequence of C++14: it passes the columns of
//! a datum to a formula as separate arguments.
template <int... K>
struct Indices
{};

//! The member Type is Indices<0, ..., N - 1>.
template <int N, int... K>
struct IndicesTo : IndicesTo<N - 1, N - 1, K...>
{};

template <int... K>
struct IndicesTo<0, K...>
{
    typedef Indices<K...> Type;
};

}  // namespace usacv20
}  // namespace cv

#endif
