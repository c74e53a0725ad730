// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_ALLOCATION_COUNTER_HPP
#define OPENCV_USACV20_TEST_ALLOCATION_COUNTER_HPP

#include <cstdlib>

namespace opencv_test {

#ifdef __GLIBC__
//! Number of allocations of any size by malloc and related functions in the whole process so far.
//! Weak, because allocation_counter.cpp is not linked where a sanitizer or valgrind replaces
//! malloc.
long allocationsSoFar() __attribute__((weak));

inline bool allocationsAreCounted() { return allocationsSoFar != 0; }
#else
inline long allocationsSoFar() { return 0; }
inline bool allocationsAreCounted() { return false; }
#endif

}  // namespace opencv_test

#endif
