// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FUZZ_BYTES_HPP
#define OPENCV_USACV20_TEST_FUZZ_BYTES_HPP

#include <cfloat>
#include <climits>
#include <cstring>
#include <limits>
#include "opencv2/core.hpp"

namespace opencv_test {

//! Reads the bytes one after another, and zeros after the last byte.
class Bytes
{
public:
    Bytes(const uchar* data, size_t size) : at(data), end(data + size), pitch(1) {}

    size_t left() const { return (size_t)(end - at); }
    int byte() { return at < end ? *at++ : 0; }
    int below(int count) { return byte() % count; }

    template <class T>
    T value()
    {
        uchar bytes[sizeof(T)];
        for (size_t i = 0; i < sizeof(T); ++i)
            bytes[i] = (uchar)byte();
        T result;
        std::memcpy(&result, bytes, sizeof(T));
        return result;
    }

    //! A critical number such as NaN or DBL_MAX, a small or round number, or an arbitrary one.
    double number()
    {
        static const double special[] = {0,
                                         -0.,
                                         1,
                                         -1,
                                         2,
                                         0.5,
                                         3,
                                         10,
                                         100,
                                         1e5,
                                         1e-3,
                                         1e3,
                                         1e-9,
                                         1e9,
                                         1e30,
                                         -1e30,
                                         1e-30,
                                         1e160,
                                         1e-160,
                                         1e300,
                                         -1e300,
                                         5e-324,
                                         1e-310,
                                         DBL_MAX,
                                         -DBL_MAX,
                                         DBL_MIN,
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity(),
                                         1 - DBL_EPSILON / 2,
                                         1 + DBL_EPSILON,
                                         0.99};
        const int kind = byte();
        if (kind < 32)
            return special[kind];
        if (kind < 128)
            return value<schar>();
        return kind < 192   ? (double)value<short>() / 16
               : kind < 240 ? (double)value<float>()
                            : value<double>();
    }

    int integer()
    {
        static const int special[] = {INT_MAX, INT_MIN, -1,  0,    1,    2,    7,    63,
                                      64,      100,     101, 1000, 1001, 1024, 1025, 65536};
        const int kind = byte();
        return kind < 16    ? special[kind]
               : kind < 128 ? below(8)
               : kind < 192 ? value<schar>()
                            : value<int>();
    }

    //! How points are made, 0 .. 11. A few values are kind 0 with another distance of the places.
    int kindOfPoints()
    {
        const int kind = byte();
        if (kind < 252)
            return kind % 12;
        pitch = number();
        return 0;
    }

    //! A coordinate of a point. There are six kinds, from few places (kind 0) to number() (kind 5
    //! or more).
    double coordinate(int kind)
    {
        switch (kind)
        {
        case 0: return below(4) * pitch;
        case 1: return value<schar>();
        case 2: return value<ushort>() / 64.;
        case 3: return (double)value<float>();
        case 4: return value<double>();
        default: return number();
        }
    }

private:
    const uchar* at;
    const uchar* end;
    double pitch;  //!< distance of the places
};

//! Coordinate 0, 1 or 2 of a point.
inline double& coordinateOf(cv::Point3d& point, int which)
{
    return which == 0 ? point.x : which == 1 ? point.y : point.z;
}

}  // namespace opencv_test

#endif
