# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""HDF5 files of matches for the command `pairs`: a file with a group for each pair, or the two
files of hloc. Reading them requires h5py."""

from __future__ import annotations

import os
import threading
import typing
from collections import OrderedDict
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple, Union, cast

from ._list_files import MATCHES, POINTS, SCORES, fail, pairOfArrays
from ._optional import need
from ._pair import Pair

if TYPE_CHECKING:
    from ._list_files import _Array, _Get

_KEPT = 64  # number of images whose keypoints stay in memory; pairs of the same image usually follow each other
_DAMAGED: Any = (OSError, KeyError, RuntimeError, ValueError, MemoryError)


def useH5py() -> Any:
    """Returns the module h5py. Raises CollectionError if the module is missing."""
    return need("h5py", "for HDF5 files")


def openFile(path: str) -> Any:
    """Opens an h5py.File for reading. Raises CollectionError if the file cannot be opened."""
    h5py = useH5py()
    try:
        file = h5py.File(path, "r")
        # By default HDF5 caches up to 32 megabytes (as stored in the file) of information on groups,
        # which occupy 200 megabytes of memory. Here the limit is 1 megabyte.
        limits = file.id.get_mdc_config()
        limits.set_initial_size, limits.initial_size, limits.max_size, limits.min_size = True, 1 << 20, 1 << 20, 1 << 19
        file.id.set_mdc_config(limits)
        return file
    except FileNotFoundError:
        fail("{}: there is no such file".format(path))
    except PermissionError:
        fail("{}: may not be read".format(path))
    except OSError:
        fail("{}: no HDF5 file, or a damaged one".format(path))


def _isGroup(item: Any) -> bool:
    return hasattr(item, "keys")


def _groups(h5py: Any, group: Any, path: str = "") -> typing.Iterator[str]:
    """Yields the paths of the groups whose first member is an array, sorted by name. Subgroups of such
    a group are ignored. `group` belongs to h5py's low-level interface, because the high-level
    interface is three times slower."""
    first = next(iter(group), None)
    if first is None:
        return
    if h5py.h5o.get_info(group, first).type == h5py.h5o.TYPE_DATASET:
        yield path
        return
    for name in sorted(group):
        try:
            child = h5py.h5g.open(group, name)
        except (KeyError, ValueError):  # an array, or a broken link
            continue
        text = name.decode("utf-8", "surrogateescape")
        yield from _groups(h5py, child, path + "/" + text if path else text)


class Groups:
    """An HDF5 file with a group for each pair, or with a single pair."""

    def __init__(self, path: str) -> None:
        self._path, self._file = path, openFile(path)
        self._only = os.path.splitext(os.path.basename(path))[0]

    def paths(self) -> typing.Iterator[str]:
        try:
            yield from _groups(useH5py(), self._file["/"].id)
        except _DAMAGED:
            fail("{}: the file is damaged".format(self._path))

    def names(self) -> typing.Iterator[str]:
        return (path or self._only for path in self.paths())

    def files(self) -> typing.Iterable[str]:
        return [self._path]

    def group(self, name: str) -> Any:
        """Returns the group with this name. Returns the file itself if the name is empty, or if there
        is no such group and the name is that of the file (a file with a single pair). Raises
        CollectionError if there is no such group and the name is a different one."""
        try:
            item = self._file[name] if name else self._file
        except _DAMAGED:
            if name != self._only:
                fail("{}: there is no such group, or it is damaged".format(self._path))
            item = self._file
        return item if _isGroup(item) else fail("{}: {} is no group".format(self._path, name))

    def close(self) -> None:
        self._file.close()

    def reader(self, name: str) -> _Get:
        """Returns a function that reads the arrays of a group by their names and returns None for a
        missing array. Raises CollectionError if there is no such group."""
        group = self.group(name)
        try:
            members = set(group)  # one access to the group instead of one for each possible name
        except _DAMAGED:
            fail("{}: {} is damaged".format(self._path, group.name))

        def get(member: str) -> Optional[_Array]:
            if member not in members:
                return None
            try:
                item = group[member]
                return None if _isGroup(item) else cast("_Array", item[()])
            except _DAMAGED:
                fail("{}: {}/{} is damaged".format(self._path, group.name, member))
            except TypeError:  # a named type, or an array of a type that NumPy does not have
                fail("{}: {}/{} is no array of numbers".format(self._path, group.name, member))

        return get

    def load(self, name: str) -> Pair:
        return pairOfArrays(name, self.reader(name), (name + " (1)", name + " (2)"))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None


class _Features:
    """hloc's file of features. It has a group for each image, with the arrays keypoints and
    image_size. The names of pairs contain the names of images with `-` instead of `/`."""

    def __init__(self, path: str) -> None:
        self._groups = Groups(path)
        self.path = path
        self._image: Dict[str, Optional[str]] = {}  # names of images by their form with `-` instead of `/`; None: ambiguous
        for name in self._groups.paths():
            dashed = name.replace("/", "-")
            self._image[dashed] = None if dashed in self._image else name
        self._kept: OrderedDict[str, Tuple[_Array, Optional[_Array]]] = OrderedDict()
        self._lock = threading.Lock()

    def close(self) -> None:
        self._groups.close()

    def image(self, dashed: str) -> Optional[str]:
        """Returns the name of the image from its form with `-` instead of `/`; None if there is no
        such image, or if there are several."""
        return self._image.get(dashed)

    def load(self, image: str) -> Tuple[_Array, Optional[_Array]]:
        """Returns the keypoints and the size (None: unknown) of an image."""
        with self._lock:
            if image in self._kept:
                self._kept.move_to_end(image)
                return self._kept[image]
        get = self._groups.reader(image)
        keypoints, size = get("keypoints"), get("image_size")
        if keypoints is None:
            fail("{}: {} has no keypoints".format(self.path, image))
        with self._lock:
            self._kept[image] = keypoints, size
            if len(self._kept) > _KEPT:
                self._kept.popitem(last=False)
        return keypoints, size


class Hloc:
    """hloc's two files: the file of matches and the file of features. The former has groups
    NAME0/NAME1 (in older versions NAME0_NAME1) with the arrays matches0 and matching_scores0. In
    both files, the center of the first pixel has the coordinates (0, 0)."""

    def __init__(self, path: str, features: str) -> None:
        self._matches, self._features = Groups(path), _Features(features)
        self._path = path

    def names(self) -> typing.Iterator[str]:
        return self._matches.names()

    def files(self) -> typing.Iterable[str]:
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
        read, loaded = self._matches.reader(name), [self._features.load(image) for image in images]
        given = {"keypoints0": loaded[0][0], "keypoints1": loaded[1][0], "image_size0": loaded[0][1],
                 "image_size1": loaded[1][1]}
        for member in MATCHES + tuple(score for score, _ in SCORES):
            given[member] = read(member)
        if all(given[member] is None for member in MATCHES):
            fail("{}: no {}".format(self._path, " or ".join(MATCHES)))
        return pairOfArrays(name, given.get, images)


def openHdf5(path: str, features: Optional[str]) -> Union[Groups, Hloc]:
    """Opens a file as a Container (see _lists.py). `features` is the path of hloc's file of
    features, if `path` is hloc's file of matches. Raises CollectionError if a file cannot be
    opened, or if `features` is None and the file has matches, but no keypoints."""
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
    """Returns the pair of a file with a single pair. Raises CollectionError if the file is damaged
    or has no pair."""
    groups = Groups(path)
    try:
        return pairOfArrays(name, groups.reader(""), (name + " (1)", name + " (2)"))
    finally:
        groups.close()
