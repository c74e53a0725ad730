# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Finds pairs whose rotation contradicts pairs with more inliers. Such pairs are due to repeated
structure, which cannot be detected from a single pair.

Matches between similar windows of different facades agree with a motion as correct matches do, and
so do the scales and angles of their keypoints. But around a loop of images, the rotations of
correct pairs multiply to the identity @cite zach2010disambiguating. Here a loop consists of the
tested pair and a path of links between its two images. A link is a pair with a single rotation
(CALIBRATED or PANORAMIC) and with at least `STRONGER` times as many inliers as the tested pair. Wrong
pairs have few inliers and are therefore rarely links. The links with the most inliers form a forest
(a graph without loops), which contains at most one path between two images. If there is no path, the
tested pair is accepted.

Pairs are tested in descending order of their numbers of inliers while the forest grows, so that
each pair is tested once."""

from __future__ import annotations

import math
import typing
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

# Unit quaternion w, x, y, z of the rotation from the coordinates of one camera to those of another.
_Rotation = Tuple[float, float, float, float]

# doc/measurements/collections_tables.md lists results with half and twice these values.

STRONGER = 2.0  # minimum ratio of the number of inliers of a link to that of the tested pair
LARGEST = 20.0  # degrees; a pair with a larger rotation error contradicts the path
LONGEST = 32  # maximum number of links in a path; longer paths are not used, because errors add up

_NONE: _Rotation = (1.0, 0.0, 0.0, 0.0)


class Edge(typing.NamedTuple):
    """An accepted pair."""

    key: Any  # determines the order of edges with equal numbers of inliers
    first: typing.Hashable  # ids of the images
    second: typing.Hashable
    inliers: int
    rotations: npt.NDArray[np.float64]  # k x 4, w, x, y, z: the possible rotations
    link: bool  # True: the pair has a single, well-determined rotation and can be a link


def contradicted(edges: typing.Sequence[Edge]) -> Dict[Any, float]:
    """Returns a dictionary from the keys of the contradicted edges to their rotation errors in
    degrees. If several rotations of an edge are possible, the smallest error counts."""
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
    """The forest of links as a union-find structure. Each image except the representative of its tree
    refers to another image of this tree and stores its rotation relative to that image; these
    references lead to the representative."""

    def __init__(self) -> None:
        self._toward: Dict[typing.Hashable, Tuple[typing.Hashable, _Rotation]] = {}  # R_image = rotation * R_other
        self._size: Dict[typing.Hashable, int] = {}
        self._links: Dict[typing.Hashable, List[typing.Hashable]] = {}

    def add(self, first: typing.Hashable, second: typing.Hashable, rotation: _Rotation) -> None:
        """Adds a link with R_second = rotation * R_first. Does nothing if a path already joins the
        images."""
        (one, ofFirst), (other, ofSecond) = self._find(first), self._find(second)
        if one == other:
            return
        between = _times(_inverse(ofSecond), _times(rotation, ofFirst))  # R_other = between * R_one
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
        """Returns the smallest angle in degrees between a rotation of the edge and the rotation
        along the path between its images; 0 if there is no path."""
        (one, ofFirst), (other, ofSecond) = self._find(edge.first), self._find(edge.second)
        if one != other:
            return 0.0
        expected = np.array(_times(ofSecond, _inverse(ofFirst)))
        cosine = float(np.abs(edge.rotations @ expected).max())
        return math.degrees(2 * math.acos(min(cosine, 1.0)))

    def near(self, first: typing.Hashable, second: typing.Hashable) -> bool:
        """Returns True if the path between two images has at most LONGEST links."""
        front, seen = [first], {first}
        for _ in range(LONGEST):
            front = [image for known in front for image in self._links.get(known, ()) if image not in seen]
            if second in front:
                return True
            seen.update(front)
        return False

    def _find(self, image: typing.Hashable) -> Tuple[typing.Hashable, _Rotation]:
        """Returns the representative of the tree of an image, and the rotation of the image
        relative to the representative. The number of steps is at most logarithmic in the number of
        images, because the smaller tree is always attached to the larger tree."""
        rotation = _NONE
        while image in self._toward:
            image, step = self._toward[image]
            rotation = _times(rotation, step)
        return image, rotation


def _asRotation(values: npt.NDArray[np.float64]) -> _Rotation:
    w, x, y, z = map(float, values)
    return w, x, y, z


def _times(a: _Rotation, b: _Rotation) -> _Rotation:
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def _inverse(a: _Rotation) -> _Rotation:
    return a[0], -a[1], -a[2], -a[3]
