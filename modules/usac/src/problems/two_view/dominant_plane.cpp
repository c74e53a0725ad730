// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/streams.hpp"
#include "problems/two_view/dominant_plane.hpp"
#include "problems/two_view/epipole.hpp"
#include "problems/share_a_point.hpp"
#include "numeric/bits.hpp"
#include "problems/kernels.hpp"

namespace cv {
namespace usacv20 {

bool planeOfThree(const Correspondences& p, const int* triple, const Matx33d& A, const Vec3d& e,
                  Matx33d& H)
{
    for (int k = 0; k < 3; ++k)  // with a shared point, H or M would be singular
        if (shareAPoint(p, triple[k], triple[(k + 1) % 3]))
            return false;
    Matx33d M;
    Vec3d b;
    for (int k = 0; k < 3; ++k)
    {
        const int i = triple[k];
        const Vec3d x1(p.exact[X1][i], p.exact[Y1][i], 1), x2(p.exact[X2][i], p.exact[Y2][i], 1);
        const Vec3d side = x2.cross(e);
        const double length = side.dot(side);
        if (!(length > 0))
            return false;
        b[k] = x2.cross(A * x1).dot(side) / length;
        for (int j = 0; j < 3; ++j)
            M(k, j) = x1[j];
    }
    const double det = determinant(M);
    if (!(std::abs(det) > 1e-9))
        return false;
    const Vec3d v = M.inv() * b;
    H = A - Matx33d(e[0] * v[0], e[0] * v[1], e[0] * v[2], e[1] * v[0], e[1] * v[1], e[1] * v[2],
                    e[2] * v[0], e[2] * v[1], e[2] * v[2]);
    return true;
}

bool epipolar(const Model& F, Vec3d& e, Matx33d& A)
{
    e = epipole2(F);
    const double length = norm(e);
    if (!(length > 0))
        return false;
    e *= 1 / length;
    A = crossMatrix(e) * Matx33d(F);
    return true;
}

bool DominantPlane::find(const Context& context, Rng& rng, const Model& F, double least, Matx33d& H)
{
    const Correspondences& p = context.points;
    Vec3d e;
    Matx33d A;
    count = 0;
    const double limit = context.inlierThreshold() * context.inlierThreshold();
    float m[9];
    toFloat(F, m);
    for (int first = 0; first < p.size && count < MAX_INLIERS; first += WORD_BITS)
    {
        float errors[WORD_BITS];
        const int size = std::min(p.size - first, (int)WORD_BITS);
        kernelsOf<SampsonError>().errors(p, m, first, first + size, errors);
        for (uint64 word = within(errors, size, (float)limit); word && count < MAX_INLIERS;
             word &= word - 1)
            members[count++] = first + lowestOne(word);
    }
    if (count < LEAST_INLIERS || !epipolar(F, e, A))
        return false;
    someInliers.gather(p, members, count);
    int most = (int)(least * count);
    bool found = false;
    for (int t = 0; t < MAX_TRIPLES; ++t)
    {
        int triple[3];
        rng.distinct(count, 3, triple);
        for (int k = 0; k < 3; ++k)
            triple[k] = members[triple[k]];
        Matx33d candidate;
        if (!planeOfThree(p, triple, A, e, candidate))
            continue;
        const int support = someInliers.count<TransferError>(candidate, planeLimit(context));
        if (support > most)
        {
            most = support;
            H = candidate;
            found = true;
        }
    }
    return found;
}

bool epipoleIsFree(const Context& context, const Model& F)
{
    // more than this fraction of the inliers must be on the plane, see doc/constants.md
    constexpr double PLANAR = 0.85;
    DominantPlane plane;
    Rng rng(context.params.seed, streamOf(STREAM_LEVERAGE));
    Matx33d H;
    return plane.find(context, rng, F, PLANAR, H);
}

}  // namespace usacv20
}  // namespace cv
