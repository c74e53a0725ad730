// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "significance/agreement.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Wrong matches of each point, at least.
enum { PARTNERS = 4 };

/** Some of the points, with the numbers that a residual wants: double for one of the caller's own, which may know
nothing of Correspondences but those of the estimation, float for the others. */
template <typename T>
class Pairing
{
public:
    Pairing(const Residual& residual_, const Model& model_, const T* x1, const T* y1, const T* x2, const T* y2,
            int count, double threshold)
        : residual(residual_), model(model_), limit((T)(threshold * threshold)), size(count), stride(2 * count),
          memory(5 * stride)
    {
        const T* const from[4] = {x1, y1, x2, y2};
        for (int k = 0; k < 4; ++k)
            std::copy(from[k], from[k] + count, row(k));
    }

    //! Marks the points that agree. @return their number
    int inliers(uchar* mask)
    {
        computeErrors(0);
        int sum = 0;
        for (int i = 0; i < size; ++i)
            sum += mask[i] = row(4)[i] <= limit;  // false for NaN
        return sum;
    }

    //! Leaves out what is marked, and writes image 2 a second time behind the first: the last points have partners,
    //! too.
    int drop(const uchar* repeated)
    {
        int kept = 0;
        for (int i = 0; i < size; ++i)
            if (!repeated[i])
            {
                for (int k = 0; k < 4; ++k)
                    row(k)[kept] = row(k)[i];
                ++kept;
            }
        size = kept;
        for (int k = 2; k < 4; ++k)
            std::copy(row(k), row(k) + size, row(k) + size);
        return size;
    }

    //! How many points of image 1 agree with those that stand `partner` places further in image 2, after drop().
    int agreeing(int partner)
    {
        computeErrors(partner);
        const T* const errors = row(4);
        int sum = 0;
        for (int i = 0; i < size; ++i)
            sum += errors[i] <= limit ? 1 : 0;
        return sum;
    }

private:
    T* row(int k) { return &memory[k * stride]; }
    void computeErrors(int partner);

    const Residual& residual;
    const Model& model;
    const T limit;
    int size;
    const int stride;
    std::vector<T> memory;  //!< x1, y1, x2, y2, errors
};

template <>
void Pairing<double>::computeErrors(int partner)
{
    residual.squaredErrors(model, row(0), row(1), row(2) + partner, row(3) + partner, size, row(4));
}

template <>
void Pairing<float>::computeErrors(int partner)
{
    Correspondences view = Correspondences();
    view.size = size;
    view.x1 = row(0);
    view.y1 = row(1);
    view.x2 = row(2) + partner;
    view.y2 = row(3) + partner;
    residual.squaredErrors(view, model, 0, size, row(4));
}

template <typename T>
Agreement count(Pairing<T>& pairing, const Correspondences& p, int count, double threshold, int pairs)
{
    std::vector<uchar> mask(2 * count);
    uchar* const repeated = &mask[count];
    Agreement found;
    found.inliers = pairing.inliers(mask.data());
    markRepeated(p.dx1, p.dy1, 0, mask.data(), count, threshold * p.T1(0, 0) / p.T2(0, 0), repeated);
    found.inliers -= markRepeated(p.dx2, p.dy2, 0, mask.data(), count, threshold, repeated);
    found.points = pairing.drop(repeated);
    found.pairs = found.agreeing = 0;
    const int partners = std::min(std::max<int>(PARTNERS, pairs / std::max(found.points, 1)), found.points - 1);
    for (int partner = 1; partner <= partners; ++partner)
    {
        found.agreeing += pairing.agreeing(partner);
        found.pairs += found.points;
    }
    return found;
}

}  // namespace

Agreement countAgreement(const Residual& residual, const Model& model, const Correspondences& p, int size,
                         double threshold, int pairs)
{
    if (residual.kind() == Residual::CUSTOM)
    {
        Pairing<double> pairing(residual, model, p.dx1, p.dy1, p.dx2, p.dy2, size, threshold);
        return count(pairing, p, size, threshold, pairs);
    }
    Pairing<float> pairing(residual, model, p.x1, p.y1, p.x2, p.y2, size, threshold);
    return count(pairing, p, size, threshold, pairs);
}

}  // namespace usacv20
}  // namespace cv
