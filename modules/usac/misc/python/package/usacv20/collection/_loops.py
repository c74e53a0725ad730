# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds pairs whose rotation contradicts pairs with more matches. They are due to repeated
structure, which cannot be detected from a single pair.

Matches between windows of different facades agree with a motion as right matches do, and so do the
scales and angles of their key points. But around a loop of images, the rotations of right pairs
multiply to the identity @cite zach2010disambiguating. Here a loop consists of the tested pair and a
path of links between its two images. A link is a calibrated pair with at least `STRONGER` times as
many inliers as the tested pair; a right pair has many links around it, a wrong pair mostly none.
The links with the most inliers form a forest (a graph without loops), which contains at most one
path between two images. If there is no path, the pair is accepted.

Pairs are tested in descending order of their inliers while the forest grows, so that each pair is
tested once."""

from __future__ import annotations

import math
import typing
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

_Rotation = Tuple[float, float, float, float]  # unit quaternion w, x, y, z; maps directions in the coordinates of one camera to those of another

# doc/collections.md has results with half and double of these values.

STRONGER = 2.0  # least ratio of the inliers of a link to those of the tested pair
LARGEST = 20.0  # largest rotation error in degrees of an accepted pair
LONGEST = 32  # largest number of links in a path, since their errors add up

_NONE: _Rotation = (1.0, 0.0, 0.0, 0.0)


class Edge(typing.NamedTuple):
    """An accepted pair."""

    key: Any  # determines the order of edges with equal numbers of inliers
    first: typing.Hashable  # ids of the images
    second: typing.Hashable
    inliers: int
    rotations: npt.NDArray[np.float64]  # k x 4, w, x, y, z: the possible rotations
    link: bool  # true: a calibrated pair with a single rotation, which can be a link


def contradicted(edges: typing.Sequence[Edge]) -> Dict[Any, float]:
    """Returns the contradicted edges and, for each, the least rotation error in degrees over its
    possible rotations."""
    order = sorted(edges, key=lambda edge: (-edge.inliers, edge.key))
    forest = _Forest()
    result: Dict[Any, float] = {}
    grown = 0
    for edge in order:
        while order[grown].inliers >= STRONGER * edge.inliers:
            link = order[grown]
            grown += 1
            if link.link and link.key not in result:
                forest.add(link.first, link.second, _asRotation(link.rotations[0]))
        error = forest.error(edge)
        if error > LARGEST and forest.near(edge.first, edge.second):
            result[edge.key] = error
    return result


class _Forest:
    """The forest of links as a union-find structure. Each image stores its rotation relative to
    another image of its tree; these references lead to a representative of the tree."""

    def __init__(self) -> None:
        self._toward: Dict[typing.Hashable, Tuple[typing.Hashable, _Rotation]] = {}  # R_image = rotation R_other
        self._size: Dict[typing.Hashable, int] = {}
        self._links: Dict[typing.Hashable, List[typing.Hashable]] = {}

    def add(self, first: typing.Hashable, second: typing.Hashable, rotation: _Rotation) -> None:
        """Adds a link with R_second = rotation R_first. Does nothing if a path joins the images
        already."""
        (one, ofFirst), (other, ofSecond) = self._find(first), self._find(second)
        if one == other:
            return
        between = _times(_inverse(ofSecond), _times(rotation, ofFirst))  # R_other = between R_one
        sizes = self._size.get(one, 1), self._size.get(other, 1)
        if sizes[0] < sizes[1]:
            self._toward[one] = other, _inverse(between)
            self._size[other] = sum(sizes)
        else:
            self._toward[other] = one, between
            self._size[one] = sum(sizes)
        self._links.setdefault(first, []).append(second)
        self._links.setdefault(second, []).append(first)

    def error(self, edge: Edge) -> float:
        """Returns the least angle in degrees between a rotation of the edge and the rotation of the
        path; 0 if there is no path."""
        (one, ofFirst), (other, ofSecond) = self._find(edge.first), self._find(edge.second)
        if one != other:
            return 0.0
        expected = np.array(_times(ofSecond, _inverse(ofFirst)))
        cosine = float(np.abs(edge.rotations @ expected).max())
        return math.degrees(2 * math.acos(min(cosine, 1.0)))

    def near(self, first: typing.Hashable, second: typing.Hashable) -> bool:
        """Returns whether the path has at most LONGEST links."""
        front, seen = [first], {first}
        for _ in range(LONGEST):
            front = [image for known in front for image in self._links.get(known, ()) if image not in seen]
            if second in front:
                return True
            seen.update(front)
        return False

    def _find(self, image: typing.Hashable) -> Tuple[typing.Hashable, _Rotation]:
        """Returns the representative of the tree, and the rotation of the image relative to it. The
        number of steps is at most logarithmic, as the smaller tree is always attached to the larger
        one."""
        rotation = _NONE
        while image in self._toward:
            image, step = self._toward[image]
            rotation = _times(rotation, step)
        return image, rotation


def _asRotation(values: npt.NDArray[np.float64]) -> _Rotation:
    w, x, y, z = values.tolist()
    return float(w), float(x), float(y), float(z)


def _times(a: _Rotation, b: _Rotation) -> _Rotation:
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def _inverse(a: _Rotation) -> _Rotation:
    return a[0], -a[1], -a[2], -a[3]
