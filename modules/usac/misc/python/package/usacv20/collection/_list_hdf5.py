# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""HDF5 files of matches for the command `pairs`: a group a pair, and hloc's two files. h5py is needed for them."""

from __future__ import annotations

import os
import threading
from collections import OrderedDict
from typing import TYPE_CHECKING, Any, Dict, Iterable, Iterator, List, Optional, Tuple, Union, cast

from ._list_files import MATCHES, POINTS, SCORES, fail, pairOfArrays
from ._optional import need
from ._pair import Pair

if TYPE_CHECKING:
    import numpy.typing as npt

    Array = npt.NDArray[Any]

_KEPT = 64  # images whose keypoints stay in memory: the pairs of an image follow each other
_DAMAGED = (OSError, KeyError, RuntimeError, ValueError, MemoryError)


def useH5py() -> Any:
    """The module. Raises CollectionError if it is missing."""
    return need("h5py", "for HDF5 files")


def openFile(path: str) -> Any:
    """An h5py.File for reading. Raises CollectionError."""
    h5py = useH5py()
    try:
        return h5py.File(path, "r")
    except FileNotFoundError:
        fail("{}: there is no such file".format(path))
    except PermissionError:
        fail("{}: may not be read".format(path))
    except OSError:
        fail("{}: no HDF5 file, or a damaged one".format(path))


def _isGroup(item: Any) -> bool:
    return hasattr(item, "keys")


def _groups(group: Any, path: str = "") -> Iterator[str]:
    """Paths of the groups that hold arrays, in the order of their names. What is below such a group is not looked at."""
    names: List[str] = sorted(group)
    if not names:
        return
    if not _isGroup(group[names[0]]):
        yield path
        return
    for name in names:
        item = group[name]
        if _isGroup(item):
            yield from _groups(item, path + "/" + name if path else name)


def _array(group: Any, name: str, path: str) -> Optional[Array]:
    if name not in group:
        return None
    try:
        item = group[name]
        return None if _isGroup(item) else cast("Array", item[()])
    except _DAMAGED:
        fail("{}: {}/{} is damaged".format(path, group.name, name))


class Groups:
    """A group a pair, or one pair."""

    def __init__(self, path: str) -> None:
        self._path, self._file = path, openFile(path)
        self._only = os.path.splitext(os.path.basename(path))[0]

    def paths(self) -> Iterator[str]:
        try:
            yield from _groups(self._file)
        except _DAMAGED:
            fail("{}: the file is damaged".format(self._path))

    def names(self) -> Iterator[str]:
        return (path or self._only for path in self.paths())

    def files(self) -> Iterable[str]:
        return [self._path]

    def group(self, name: str) -> Any:
        """The file itself if name is empty. Raises CollectionError."""
        try:
            item = self._file[name] if name and (name in self._file or name != self._only) else self._file
        except _DAMAGED:
            fail("{}: there is no such group, or it is damaged".format(self._path))
        return item if _isGroup(item) else fail("{}: {} is no group".format(self._path, name))

    def close(self) -> None:
        self._file.close()

    def array(self, group: Any, name: str) -> Optional[Array]:
        return _array(group, name, self._path)

    def load(self, name: str) -> Pair:
        group = self.group(name)
        return pairOfArrays(name, lambda member: self.array(group, member), (name + " (1)", name + " (2)"))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None


class _Features:
    """hloc's file of features: a group an image with keypoints and image_size. In names of pairs `-` takes the place of `/`."""

    def __init__(self, path: str) -> None:
        self._groups = Groups(path)
        self.path = path
        self._image: Dict[str, Optional[str]] = {}  # None: of several images
        for name in self._groups.paths():
            dashed = name.replace("/", "-")
            self._image[dashed] = None if dashed in self._image else name
        self._kept: OrderedDict[str, Tuple[Array, Optional[Array]]] = OrderedDict()
        self._lock = threading.Lock()

    def close(self) -> None:
        self._groups.close()

    def image(self, dashed: str) -> Optional[str]:
        """Name of the image, None: there is none, or there are several."""
        return self._image.get(dashed)

    def load(self, image: str) -> Tuple[Array, Optional[Array]]:
        """Keypoints and size."""
        with self._lock:
            if image in self._kept:
                self._kept.move_to_end(image)
                return self._kept[image]
        group = self._groups.group(image)
        keypoints, size = (self._groups.array(group, name) for name in ("keypoints", "image_size"))
        if keypoints is None:
            fail("{}: {} has no keypoints".format(self.path, image))
        with self._lock:
            self._kept[image] = keypoints, size
            if len(self._kept) > _KEPT:
                self._kept.popitem(last=False)
        return keypoints, size


class Hloc:
    """hloc's files: groups NAME0/NAME1, of older versions NAME0_NAME1, with matches0 and matching_scores0, and the features of
    the images. The middle of the first pixel is 0,0 in both."""

    def __init__(self, path: str, features: str) -> None:
        self._matches, self._features = Groups(path), _Features(features)
        self._path = path

    def names(self) -> Iterator[str]:
        return self._matches.names()

    def files(self) -> Iterable[str]:
        return [self._path, self._features.path]

    def close(self) -> None:
        self._matches.close()
        self._features.close()

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        splits = [name.split("/")] if "/" in name else [
            [name[:i], name[i + 1:]] for i, letter in enumerate(name) if letter == "_"]
        found = {tuple(self._features.image(part) for part in parts) for parts in splits if len(parts) == 2}
        known = [(first, second) for first, second in found if first is not None and second is not None]
        return known[0] if len(known) == 1 else None

    def load(self, name: str) -> Pair:
        images = self.images(name)
        if images is None:
            fail("{}: does not have its two images, or has several by these names".format(self._features.path))
        group, loaded = self._matches.group(name), [self._features.load(image) for image in images]
        instead = {"keypoints0": loaded[0][0], "keypoints1": loaded[1][0], "image_size0": loaded[0][1],
                   "image_size1": loaded[1][1]}
        if all(name not in group for name in MATCHES):
            fail("{}: no {}".format(self._path, " or ".join(MATCHES)))
        scores = [score for score, _ in SCORES]

        def get(member: str) -> Optional[Array]:
            if member in instead:
                return instead[member]
            return self._matches.array(group, member) if member in MATCHES or member in scores else None

        return pairOfArrays(name, get, images)


def openHdf5(path: str, features: Optional[str]) -> Union[Groups, Hloc]:
    """The container of a file. Raises CollectionError."""
    if features is not None:
        return Hloc(path, features)
    groups = Groups(path)
    first = next(groups.paths(), None)
    if first is not None:
        group = groups.group(first or next(groups.names()))
        if any(name in group for name in MATCHES) and not any(name in group for both in POINTS for name in both):
            groups.close()
            fail("{}: has matches, but no keypoints; hloc has them in a second file (--keypoints)".format(path))
    return groups


def pairOfHdf5(name: str, path: str) -> Pair:
    """The pair of a file of one. Raises CollectionError."""
    groups = Groups(path)
    try:
        return pairOfArrays(name, lambda member: groups.array(groups.group(""), member), (name + " (1)", name + " (2)"))
    finally:
        groups.close()
