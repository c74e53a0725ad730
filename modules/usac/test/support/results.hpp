// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RESULTS_HPP
#define OPENCV_USACV20_TEST_RESULTS_HPP

// Result has all values that a call returns, and functions that hash these values.

#include "support/contracts.hpp"

namespace opencv_test {

//! The 64-bit FNV-1a hash.
class Hash
{
public:
    Hash() : state(0xcbf29ce484222325ULL) {}

    Hash& add(const void* data, size_t size);
    Hash& add(const Mat& mat);
    template <class T>
    Hash& number(T value)
    {
        return add(&value, sizeof(value));
    }
    uint64 value() const { return state; }

private:
    uint64 state;
};

struct Result
{
    Mat model, mask;
    Report report;

    //! Hash of the bits of the model and the mask, and of the counts, the stop reason, the
    //! threshold, the cost and the chance of the report.
    uint64 exact() const;
    //! Hash of the mask, the number of iterations and the stop reason.
    uint64 robust() const;
};

Result resultOf(const Scene& scene, const Params& params);

}  // namespace opencv_test

#endif
