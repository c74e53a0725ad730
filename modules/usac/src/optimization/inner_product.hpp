// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INNER_PRODUCT_HPP
#define OPENCV_USACV20_INNER_PRODUCT_HPP

#include <Eigen/Core>

namespace cv {
namespace usacv20 {

//! Inner product of vectors. The result has the same bits with every version of Eigen, unlike the
//! result of dot(): since Eigen 5, dot() adds 8 or more numbers in another order.
template <class First, class Second>
double innerProduct(const Eigen::MatrixBase<First>& a, const Eigen::MatrixBase<Second>& b)
{
    return a.cwiseProduct(b).sum();
}

}  // namespace usacv20
}  // namespace cv

#endif
