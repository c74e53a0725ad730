// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_WRITTEN_HPP
#define OPENCV_USACV20_WRITTEN_HPP

#include <algorithm>
#include <vector>
#include "opencv2/usac/data.hpp"

namespace cv {
namespace usacv20 {

//! Numbers that a method of the program writes, and numbers behind them, which must not change.
template <class T>
class Written
{
public:
    explicit Written(int room) : numbers(room + BEHIND, (T)UNTOUCHED) {}
    T* data() { return numbers.data(); }
    //! True if exactly the first `count` numbers have been written.
    bool exactly(int count) const
    {
        const auto end = numbers.begin() + count;
        return std::find(numbers.begin(), end, (T)UNTOUCHED) == end &&
               std::count(end, numbers.end(), (T)UNTOUCHED) == numbers.end() - end;
    }

private:
    enum { BEHIND = MAX_MODEL_SIZE * MAX_MODEL_SIZE, UNTOUCHED = -98765 };
    std::vector<T> numbers;
};

}  // namespace usacv20
}  // namespace cv

#endif
