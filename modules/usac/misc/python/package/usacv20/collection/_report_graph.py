# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The graph whose nodes are images and whose edges are verified pairs: its components and its
bridges."""

from __future__ import annotations

import itertools
import typing
from typing import TYPE_CHECKING, Any, List, Tuple

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    _Numbers = npt.NDArray[np.int64]

Edge = Tuple[int, int]


class _Forest:
    """Connected components as a union-find structure."""

    def __init__(self, count: int) -> None:
        self._parent = list(range(count))

    def root(self, node: int) -> int:
        parent = self._parent
        while parent[node] != node:
            parent[node] = parent[parent[node]]
            node = parent[node]
        return node

    def join(self, first: int, second: int) -> bool:
        """Joins two components. Returns False if both nodes are already in the same component."""
        first, second = self.root(first), self.root(second)
        if first == second:
            return False
        self._parent[max(first, second)] = min(first, second)
        return True


class Bridge(typing.NamedTuple):
    """An edge whose removal splits a component."""

    first: int
    second: int
    images: int  # number of images in the smaller part


class Graph(typing.NamedTuple):
    components: List[int]  # number of images of each component, in descending order
    bridges: List[Bridge]  # sorted by Bridge.images, in descending order


def graphOf(count: int, links: typing.Iterable[Edge]) -> Graph:
    """Returns the graph of `count` images. The memory depends on the number of images, not on the
    number of links: a spanning forest of all links, and a second one of the remaining links,
    together have the same bridges as all links (the sparse certificate of Nagamochi and Ibaraki,
    1992)."""
    forest, second = _Forest(count), _Forest(count)
    kept: List[Edge] = []
    for edge in links:
        if edge[0] != edge[1] and (forest.join(*edge) or second.join(*edge)):
            kept.append(edge)
    sizes = np.bincount([forest.root(node) for node in range(count)], minlength=1)
    return Graph(sorted((int(size) for size in sizes if size), reverse=True),
                 sorted(_bridges(count, kept), key=lambda bridge: (-bridge.images, bridge)))


def _neighbors(count: int, edges: List[Edge]) -> Tuple[_Numbers, _Numbers, _Numbers]:
    """Returns arrays (start, neighbors, indices): the neighbors of node i are
    neighbors[start[i]:start[i + 1]], and indices[start[i]:start[i + 1]] are the indices in `edges`
    of the edges to these neighbors."""
    ends = np.array(edges, np.int64).reshape(-1, 2)
    origins, targets = ends.T.ravel(), ends[:, ::-1].T.ravel()
    order = np.argsort(origins, kind="stable")
    start = np.zeros(count + 1, np.int64)
    np.cumsum(np.bincount(origins, minlength=count), out=start[1:])
    return start, targets[order], np.tile(np.arange(len(ends)), 2)[order]


def _bridges(count: int, edges: List[Edge]) -> typing.Iterator[Bridge]:
    """Yields the bridges, by Tarjan's algorithm: an edge of a depth-first search tree is a bridge
    if no other edge connects the subtree below it with the nodes above it."""
    lists: Any = [array.tolist() for array in _neighbors(count, edges)]
    start, targets, numbers = lists
    entered, low, below = [-1] * count, [0] * count, [1] * count
    following = list(start[:-1])
    clock = 0
    for root in range(count):
        if entered[root] >= 0:
            continue
        found: List[Edge] = []
        stack = [(root, -1)]
        entered[root] = low[root] = clock
        clock += 1
        while stack:
            node, arrival = stack[-1]
            if following[node] < start[node + 1]:
                position = following[node]
                following[node] += 1
                target = targets[position]
                if entered[target] < 0:
                    entered[target] = low[target] = clock
                    clock += 1
                    stack.append((target, numbers[position]))
                elif numbers[position] != arrival:
                    low[node] = min(low[node], entered[target])
                continue
            stack.pop()
            if stack:
                parent = stack[-1][0]
                low[parent] = min(low[parent], low[node])
                below[parent] += below[node]
                if low[node] > entered[parent]:
                    found.append((parent, node))
        for parent, node in found:
            yield Bridge(parent, node, min(below[node], below[root] - below[node]))


def indexed(images: _Numbers, links: typing.Iterable[Tuple[int, int, int, int]]) -> typing.Iterator[_Numbers]:
    """Replaces the image ids in links by their indices in the sorted array `images`. Yields blocks
    of rows. Links with an image that is not in `images` are left out."""
    rows = iter(links)
    for block in iter(lambda: list(itertools.islice(rows, 4096)), []):
        values = np.array(block, np.int64)
        places = np.searchsorted(images, values[:, :2])
        if len(images):
            known = (images[np.minimum(places, len(images) - 1)] == values[:, :2]).all(axis=1)
            yield np.column_stack((places, values[:, 2:]))[known]


def matrixOf(count: int, blocks: typing.Iterable[_Numbers], verified: int, most: int) -> _Numbers:
    """Returns a matrix with a row and a column for each image. A cell contains the largest number
    of inliers of its pairs, -1 if none of its pairs is verified, and -2 if it has no pairs. If
    there are more than `most` images, several images share a row and a column."""
    size = min(count, most)
    cells = np.full((size, size), -2, np.int64)
    for block in blocks:
        rows, columns = (block[:, side] * size // max(count, 1) for side in (0, 1))
        inliers = np.where(block[:, 3] == verified, block[:, 2], -1)
        np.maximum.at(cells, (rows, columns), inliers)
        np.maximum.at(cells, (columns, rows), inliers)
    return cells
