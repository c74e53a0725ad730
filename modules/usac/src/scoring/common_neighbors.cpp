// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/common_neighbors.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The nearest neighbors of a point, nearest first.
struct Nearest
{
    Nearest() : count(0) {}

    //! A further point is added only if its squared distance is below this limit.
    float limit() const { return count < NEIGHBORS_COMPARED ? FLT_MAX : distance[count - 1]; }

    void add(int neighbor, float squared)
    {
        int place = count < NEIGHBORS_COMPARED ? count++ : NEIGHBORS_COMPARED - 1;
        for (; place > 0 && distance[place - 1] > squared; --place)
        {
            distance[place] = distance[place - 1];
            index[place] = index[place - 1];
        }
        distance[place] = squared;
        index[place] = neighbor;
    }

    int count, index[NEIGHBORS_COMPARED];
    float distance[NEIGHBORS_COMPARED];
};

//! A match, as seen from one of the two images: its point in this image, and its point in the other
//! image.
struct Place
{
    float x, y, otherX, otherY;
    int index;
};

float square(float x) { return x * x; }

//! The matches sorted by the x coordinates of their points in one image, to find the nearest
//! neighbors of each point in this image.
class SortedPlaces
{
public:
    //! @param same_, otherSame_ squared distances, in this image and in the other one, up to which
    //! two points count as the same point, so that their matches are not neighbors
    SortedPlaces(const Correspondences& p, int image, int count_, float same_, float otherSame_,
                 Arena::Scope& scope)
        : count(count_), places(scope.take<Place>(count)), same(same_), otherSame(otherSame_)
    {
        const int x = image ? X2 : X1, y = image ? Y2 : Y1, otherX = image ? X1 : X2,
                  otherY = image ? Y1 : Y2;
        for (int i = 0; i < count; ++i)
        {
            const Place place = {p.column[x][i], p.column[y][i], p.column[otherX][i],
                                 p.column[otherY][i], i};
            places[i] = place;
        }
        std::sort(places, places + count, [](const Place& a, const Place& b) {
            return a.x != b.x ? a.x < b.x : a.index < b.index;
        });
    }

    //! Finds the neighbors of all matches.
    void find(Nearest* nearest) const
    {
        for (int k = 0; k < count; ++k)
        {
            Nearest& found = nearest[places[k].index];
            found = Nearest();
            // until all further matches on both sides are too far away along x
            bool before = true, after = true;
            for (int step = 1; before || after; ++step)
            {
                before = before && k - step >= 0 && look(k, k - step, found);
                after = after && k + step < count && look(k, k + step, found);
            }
        }
    }

private:
    //! Adds the match `other` to the neighbors of the match `center` if it is near enough. @return
    //! false if it is too far away along x
    bool look(int center, int other, Nearest& found) const
    {
        const Place &a = places[center], &b = places[other];
        const float along = square(a.x - b.x);
        if (!(along < found.limit()))
            return false;
        const float squared = along + square(a.y - b.y);
        if (squared < found.limit() && squared > same &&
            square(a.otherX - b.otherX) + square(a.otherY - b.otherY) > otherSame)
            found.add(b.index, squared);
        return true;
    }

    const int count;
    Place* const places;
    const float same, otherSame;
};

}  // namespace

bool hasCommonNeighbors(const Problem& problem)
{
    return problem.coordinates(0) == 2 && problem.coordinates(1) == 2 && problem.commonUnit() &&
           problem.errorDimension() == 1 && problem.dimension() >= 7;
}

void commonNeighbors(const Correspondences& points, int count, double threshold, uchar* common,
                     Arena& arena)
{
    Arena::Scope scope(arena);
    Nearest* nearest[2];
    float same[2];
    for (int image = 0; image < 2; ++image)
        same[image] = (float)((image ? 1 : points.frame[0].scale / points.frame[1].scale) *
                              threshold);
    for (int image = 0; image < 2; ++image)
    {
        nearest[image] = scope.take<Nearest>(count);
        SortedPlaces(points, image, count, square(same[image]), square(same[1 - image]), scope)
            .find(nearest[image]);
    }
    for (int i = 0; i < count; ++i)
    {
        const Nearest &first = nearest[0][i], &second = nearest[1][i];
        common[i] = 0;
        for (int k = 0; k < first.count; ++k)
            common[i] += std::find(second.index, second.index + second.count, first.index[k]) !=
                         second.index + second.count;
    }
}

}  // namespace usacv20
}  // namespace cv
