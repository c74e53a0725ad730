// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

/* The homography that maps four points exactly, in closed form, and the test of the orientation of
four points, for several samples at once, each in one lane of the vector registers (see
pack.inl.hpp). The matrices B1 and B2 map the standard projective basis to the four points in image
1 and in image 2; H = B2 adj(B1), up to scale @cite hartley2003multiple. A sample with three
(nearly) collinear points or two equal points in either image is degenerate. No include guard:
lanes/lane_kernels.inl.hpp includes this file once for each instruction set. */

namespace cv {
namespace usacv20 {
namespace {

//! Three points count as collinear if twice the area of their triangle is at most this fraction of
//! the largest squared distance between the last point of the sample and one of its other points.
constexpr double COLLINEAR = 1e-6;

//! The four points of a sample in one image, and their triangles.
struct FourPoints
{
    //! @param x, y columns of the coordinates. Lanes beyond `count` repeat the last sample.
    FourPoints(const double* x, const double* y, const int* const* samples, int count)
    {
        Pack px[4], py[4];
        for (int i = 0; i < 4; ++i)
        {
            double values[2][WIDTH];
            for (int k = 0; k < WIDTH; ++k)
            {
                const int index = samples[k < count ? k : count - 1][i];
                values[0][k] = x[index];
                values[1][k] = y[index];
            }
            px[i] = load(values[0]);
            py[i] = load(values[1]);
        }
        Pack dx[3], dy[3];  // vectors from the last point to the others
        extent = Pack();
        for (int i = 0; i < 3; ++i)
        {
            first[0][i] = px[i];
            first[1][i] = py[i];
            dx[i] = px[i] - px[3];
            dy[i] = py[i] - py[3];
            extent = largerOf(extent, dx[i] * dx[i] + dy[i] * dy[i]);
        }
        area[0] = dx[1] * dy[2] - dx[2] * dy[1];
        area[1] = dx[2] * dy[0] - dx[0] * dy[2];
        area[2] = dx[0] * dy[1] - dx[1] * dy[0];
        area[3] = area[0] + area[1] + area[2];
    }

    //! The lanes in which no three points are collinear.
    Mask general() const
    {
        const Pack smallest = smallerOf(smallerOf(absolute(area[0]), absolute(area[1])),
                                        smallerOf(absolute(area[2]), absolute(area[3])));
        return smallest > COLLINEAR * extent;  // a NaN is rejected, too
    }

    //! Computes the matrix B that maps the standard projective basis to the points. Its columns are
    //! the first three points in homogeneous coordinates, scaled so that their sum is a multiple of
    //! the fourth point.
    void fromBasis(Pack (&B)[9]) const
    {
        for (int k = 0; k < 3; ++k)
        {
            B[k] = area[k] * first[0][k];
            B[3 + k] = area[k] * first[1][k];
            B[6 + k] = area[k];
        }
    }

    Pack first[2][3];  //!< x and y of the first three points
    //! Twice the signed areas of the triangles: without the first, second, third and fourth point.
    Pack area[4];
    Pack extent;  //!< largest squared distance between the fourth point and another one
};

//! Solves `count` samples, at most WIDTH.
void solveFour(const Correspondences& points, const int* const* samples, int count,
               double (*models)[MAX_MODELS][9], int* found)
{
    const FourPoints p1(points.exact[X1], points.exact[Y1], samples, count),
        p2(points.exact[X2], points.exact[Y2], samples, count);
    Pack B1[9], B2[9], c[9], H[9], squares = Pack();
    p1.fromBasis(B1);
    p2.fromBasis(B2);
    cofactors(B1, c);  // adj(B1) is the transpose of the matrix of cofactors
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            const Pack h = dot3(B2[3 * i], c[3 * j], B2[3 * i + 1], c[3 * j + 1], B2[3 * i + 2],
                                c[3 * j + 2]);
            H[3 * i + j] = h;
            squares += h * h;
        }
    const Pack inverse = 1. / squareRoot(squares);
    for (int i = 0; i < 9; ++i)
        H[i] *= inverse;
    const int solved = bitsOf(p1.general() & p2.general() & (squares >= DBL_MIN) &
                              (squares <= DBL_MAX));
    for (int k = 0; k < count; ++k)
    {
        found[k] = solved >> k & 1;
        for (int i = 0; i < 9; ++i)
            models[k][0][i] = lane(H[i], k);
    }
}

void fourPointKernel(const Correspondences& points, const int* const* samples, int count,
                     double (*models)[MAX_MODELS][9], int* found)
{
    for (int i = 0; i < count; i += WIDTH)
        solveFour(points, samples + i, count - i < WIDTH ? count - i : WIDTH, models + i,
                  found + i);
}

//! Tests whether all triangles keep their orientation or all reverse it.
void orientationKernel(const Correspondences& points, const int* const* samples, int count,
                       bool* valid)
{
    for (int first = 0; first < count; first += WIDTH)
    {
        const int left = count - first < WIDTH ? count - first : WIDTH;
        const FourPoints p1(points.exact[X1], points.exact[Y1], samples + first, left),
            p2(points.exact[X2], points.exact[Y2], samples + first, left);
        int all = ~0, any = 0;
        for (int t = 0; t < 4; ++t)
        {
            const int same = bitsOf(p1.area[t] * p2.area[t] > 0.);
            all &= same;
            any |= same;
        }
        for (int k = 0; k < left; ++k)
            valid[first + k] = ((all | ~any) >> k & 1) != 0;
    }
}

}  // namespace
}  // namespace usacv20
}  // namespace cv
