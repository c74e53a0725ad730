# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Pairs whose rotation contradicts that of pairs with more matches: repeated structure, which a pair by itself does not tell.

Windows that are matched with those of another facade agree with a motion as right matches do, and so do the scales and angles
of their key points. But rotations around a loop of images multiply to the identity if all its pairs are right
@cite zach2010disambiguating. Here a loop is one pair and the path of links between its two images, in the forest that has the
links with the most inliers; a link is a calibrated pair that has `STRONGER` times the inliers of the pair that is judged: of
those right pairs have many around them, and wrong ones mostly none. A pair between images that no such path joins is kept.

Pairs are judged from those with the most inliers to those with the least, and the forest grows with them, so that each pair is
looked at once."""

from __future__ import annotations

import math
import typing
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

_Rotation = Tuple[float, float, float, float]  # w, x, y, z; takes directions of one camera to those of another one

# Half and double of these: doc/collections.md.

STRONGER = 2.0  # inliers of a link, in terms of those of the pair that is judged
LARGEST = 20.0  # degrees
LONGEST = 32  # links in a path: the errors of many add up

_NONE: _Rotation = (1.0, 0.0, 0.0, 0.0)


class Edge(typing.NamedTuple):
    """A pair that is kept."""

    key: Any  # orders edges with as many inliers
    first: typing.Hashable  # images
    second: typing.Hashable
    inliers: int
    rotations: npt.NDArray[np.float64]  # k x 4, w, x, y, z: those that are possible
    link: bool  # one rotation, of a calibrated pair, by which others are judged


def contradicted(edges: typing.Sequence[Edge]) -> Dict[Any, float]:
    """Returns which edges are contradicted by others, and by how many degrees at least."""
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
    """Images and the links between them. Each image knows its rotation in terms of another one, up to a representative of its
    tree."""

    def __init__(self) -> None:
        self._toward: Dict[typing.Hashable, Tuple[typing.Hashable, _Rotation]] = {}  # R_image = rotation R_other
        self._size: Dict[typing.Hashable, int] = {}
        self._links: Dict[typing.Hashable, List[typing.Hashable]] = {}

    def add(self, first: typing.Hashable, second: typing.Hashable, rotation: _Rotation) -> None:
        """R_second = rotation R_first. Nothing happens if a path joins them."""
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
        """Returns the least angle, in degrees, between a rotation of the edge and that of the path; 0: there is no path."""
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
        """The representative, and R_image in terms of its rotation. The steps are at most as many as the logarithm of the images,
        as smaller trees are joined to larger ones."""
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
