# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The source of the command `pairs`: matches in files, one a pair, or in one file with a group a pair.

LIST is one of
- a folder (with those below it) of `.corr` files, a match a line, `x1 y1 x2 y2 score`, and beside them `.json` files with the
  sizes of the images and their camera matrices (see doc/benchmark.md), or of `.npz`, or of `.h5` or `.hdf5` files, a pair each,
- a `.list` file that names such files without extension, a line each, relative to its folder or, if that is called `lists`, to
  the one above it,
- an `.npz` file with arrays PAIR/NAME, or `.h5` or `.hdf5` file with arrays NAME in groups PAIR, or of one pair,
- hloc's `.h5` file of matches together with that of features.

Arrays, all in pixels and without distortion:
- points1, points2 (or mkpts0, mkpts1): N x 2, row i of one matches row i of the other,
- or keypoints0, keypoints1 (or keypoints1, keypoints2): as those; with matches0 or matches: for each keypoint of image 1 the
  number of its match, negative: it has none; or M x 2 numbers,
- scores (or matching_scores0, matching_scores, match_confidence, confidence, mconf; higher is better) or ratios (lower is
  better): one for each match, or for each keypoint of image 1,
- K1, K2 (or K0, K1; or K, of both images): 3 x 3; without them the focal length is taken for unknown,
- size1, size2 (or size0, size1; or with image_size in the place of size): width and height.

Without K1 and K2 only F and H can be found. A pair is called by its file without the extension, relative to the folder, by its
line of the list, or by its group."""

from __future__ import annotations

import hashlib
import heapq
import os
import typing
import zipfile
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple, Union, cast

import numpy as np

from ._list_files import UNREADABLE, fail, pairOfArrays, pairOfCorr, pairOfNpz
from ._pair import CollectionError, Fault, Key, Pair

if TYPE_CHECKING:
    import numpy.typing as npt

HDF5 = (".h5", ".hdf5")
EXTENSIONS = (".corr", ".npz") + HDF5
BATCH = 1 << 16  # entries of a folder that are sorted at once: some ten megabytes of names


class Container(typing.Protocol):
    """The files of a LIST, which ListSource opens in each process."""

    def names(self) -> typing.Iterator[str]:
        """Returns the names of all pairs in a fixed order, as a stream."""

    def files(self) -> typing.Iterable[str]:
        """Returns the files from which the pairs come."""

    def load(self, name: str) -> Pair:
        """Returns a pair. Raises CollectionError if it cannot be read."""

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        """Returns the names of the images of a pair; None: not known."""

    def close(self) -> None:
        """Closes the files that are open."""


def inOrder(entries: Callable[[], typing.Iterable[str]], batch: int) -> typing.Iterator[str]:
    """Returns different strings in order, however many, with `batch` of them in memory: each pass finds those that follow the last one."""
    last = ""
    while True:
        found = heapq.nsmallest(batch, (entry for entry in entries() if entry > last))
        yield from found
        if len(found) < batch:
            return
        last = found[-1]


def _loadFile(name: str, path: str) -> Pair:
    extension = os.path.splitext(path)[1].lower()
    if extension == ".corr":
        return pairOfCorr(name, path)
    if extension == ".npz":
        return pairOfNpz(name, path)
    from ._list_hdf5 import pairOfHdf5
    return pairOfHdf5(name, path)


def _withDescription(path: str) -> List[str]:
    beside = os.path.splitext(path)[0] + ".json"
    return [path, beside] if path.lower().endswith(".corr") and os.path.exists(beside) else [path]


class Folder:
    """A folder with a file for each pair, all with the same extension."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._extension = ""
        # Looked for once, in no order: it is the same for all files, or the first two that differ are a mistake.
        for file in self._walk("", self._scanned):
            extension = os.path.splitext(file)[1]
            self._extension = self._extension or extension
            if extension.lower() != self._extension.lower():
                fail("{}: has both {} and {} files".format(path, *sorted((extension, self._extension))))
        if not self._extension:
            fail("{}: no {} files".format(path, ", ".join(EXTENSIONS)))

    def _scanned(self, folder: str) -> typing.Iterator[str]:
        """Entries of interest; folders end in '/'. Links to folders are not followed, they may lead back."""
        with os.scandir(os.path.join(self._path, folder)) as entries:
            for entry in entries:
                if entry.name.startswith("."):
                    continue
                if entry.is_dir(follow_symlinks=False):
                    yield entry.name + "/"
                elif entry.name.lower().endswith(EXTENSIONS):
                    yield entry.name

    def _walk(self, folder: str, entries: Callable[[str], typing.Iterable[str]]) -> typing.Iterator[str]:
        """Returns the relative paths of the files."""
        try:
            for entry in entries(folder):
                if entry.endswith("/"):
                    yield from self._walk(folder + entry, entries)
                else:
                    yield folder + entry
        except OSError as error:
            fail("{}: {}".format(os.path.join(self._path, folder), error.strerror))

    def _sorted(self) -> typing.Iterator[str]:
        return self._walk("", lambda folder: inOrder(lambda: self._scanned(folder), BATCH))

    def names(self) -> typing.Iterator[str]:
        return (os.path.splitext(file)[0] for file in self._sorted())

    def files(self) -> typing.Iterator[str]:
        for file in self._sorted():
            yield from _withDescription(os.path.join(self._path, file))

    def load(self, name: str) -> Pair:
        return _loadFile(name, os.path.join(self._path, name + self._extension))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None

    def close(self) -> None:
        pass


class ListFile:
    """A file that names those of the pairs."""

    def __init__(self, path: str) -> None:
        kind = os.path.basename(path)[:-len(".list")].rpartition(".")[2]
        if kind in ("P", "R", "M"):  # absolute poses, motions of space
            fail("{}: these are no pairs of images".format(path))
        folder = os.path.dirname(os.path.abspath(path))
        self._path = path
        self._base = os.path.dirname(folder) if os.path.basename(folder) == "lists" else folder

    def names(self) -> typing.Iterator[str]:
        try:
            with open(self._path, encoding="utf-8") as lines:
                for line in lines:
                    line = line.strip()
                    if line and not line.startswith("#"):
                        yield line
        except (OSError, UnicodeDecodeError) as error:
            fail("{}: {}".format(self._path, error.strerror if isinstance(error, OSError) else "no text"))

    def _file(self, name: str) -> str:
        path = os.path.join(self._base, name)
        return next((path + extension for extension in EXTENSIONS if os.path.exists(path + extension)), path + EXTENSIONS[0])

    def files(self) -> typing.Iterator[str]:
        yield self._path
        for name in self.names():
            yield from _withDescription(self._file(name))

    def load(self, name: str) -> Pair:
        return _loadFile(name, self._file(name))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None

    def close(self) -> None:
        pass


class NpzFile:
    """An NPZ file with arrays PAIR/NAME, or those of one pair. A zip file has one directory, which is read as a whole: 1.5
    kilobytes of memory for two arrays of a pair. For millions of pairs take a folder or HDF5."""

    def __init__(self, path: str) -> None:
        self._path = path
        try:
            # Not by numpy.load, which looks through all names for one.
            self._zip = zipfile.ZipFile(path)
        except UNREADABLE as error:
            fail("{}: {}".format(path, error.strerror if isinstance(error, OSError) and error.strerror
                                 else "no NPZ file, or a damaged one"))
        self._prefixes: Dict[str, str] = {}
        for member in self._zip.namelist():
            group = member.rpartition("/")[0]
            self._prefixes[group or os.path.splitext(os.path.basename(path))[0]] = group + "/" if group else ""

    def names(self) -> typing.Iterator[str]:
        return iter(sorted(self._prefixes))

    def files(self) -> typing.Iterable[str]:
        return [self._path]

    def _get(self, member: str) -> Optional[npt.NDArray[Any]]:
        try:
            file = self._zip.open(member + ".npy")
        except KeyError:
            return None
        except UNREADABLE:
            fail("{}: {} is damaged".format(self._path, member))
        try:
            with file:
                array = np.lib.format.read_array(file, allow_pickle=False)  # type: ignore[no-untyped-call]
            return cast("npt.NDArray[Any]", array)
        except UNREADABLE:
            fail("{}: {} is damaged".format(self._path, member))

    def load(self, name: str) -> Pair:
        if name not in self._prefixes:
            fail("{}: there is no such pair".format(self._path))
        prefix = self._prefixes[name]
        return pairOfArrays(name, lambda member: self._get(prefix + member), (name + " (1)", name + " (2)"))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None

    def close(self) -> None:
        self._zip.close()


def _open(path: str, features: Optional[str]) -> Container:
    if not os.path.exists(path):
        fail("{}: there is no such file or folder".format(path))
    extension = os.path.splitext(path)[1].lower()
    if features is not None and extension not in HDF5:
        fail("{}: features go with an HDF5 file of matches".format(path))
    if os.path.isdir(path):
        return Folder(path)
    if extension == ".list":
        return ListFile(path)
    if extension == ".npz":
        return NpzFile(path)
    if extension in HDF5:
        from ._list_hdf5 import openHdf5
        return openHdf5(path, features)
    fail("{}: a folder, or a file {} is expected".format(path, ", ".join((".list",) + EXTENSIONS[1:])))


class ListSource:
    """The pairs of LIST, see the top of this file. `features`: hloc's file of keypoints if LIST is that of its matches. Raises
    CollectionError if there is none, or if it has no pairs."""

    def __init__(self, path: str, features: Optional[str] = None) -> None:
        # Workers may run in another folder.
        self._path = os.path.abspath(path)
        self._features = None if features is None else os.path.abspath(features)
        self._opened: Optional[Tuple[int, Container]] = None
        self._count = sum(1 for _ in self.keys())
        if not self._count:
            fail("{}: has no pairs".format(path))

    def __getstate__(self) -> Dict[str, Any]:
        return dict(self.__dict__, _opened=None)

    def _container(self) -> Container:
        """Opened once in each process: one that was forked must not share the file positions of its parent."""
        process = os.getpid()
        if self._opened is None or self._opened[0] != process:
            self._opened = process, _open(self._path, self._features)
        return self._opened[1]

    def keys(self) -> typing.Iterator[Key]:
        for name in self._container().names():
            try:
                name.encode("utf-8")
            except UnicodeEncodeError:  # the results could not name it
                fail("{}: {!r} is not in UTF-8".format(self._path, name))
            yield name

    def __len__(self) -> int:
        return self._count

    def load(self, keys: typing.Sequence[Key]) -> List[Union[Pair, Fault]]:
        container = self._container()
        loaded: List[Union[Pair, Fault]] = []
        for key in keys:
            try:
                loaded.append(container.load(str(key)))
            except CollectionError as error:
                loaded.append(Fault(key, "{}: {}".format(key, error)))
        return loaded

    def images(self, key: Key) -> Optional[Tuple[str, str]]:
        """Returns the names of the images of a pair; None where the files do not tell them."""
        return self._container().images(str(key))

    def close(self) -> None:
        """Closes what this process has opened; no thread may be using it. The next use opens it again."""
        if self._opened is not None and self._opened[0] == os.getpid():
            self._opened[1].close()
        self._opened = None

    def fingerprint(self) -> str:
        """Returns a fingerprint of the names, sizes and times of all files."""
        digest = hashlib.sha256()
        for file in self._container().files():
            try:
                stat = os.stat(file)
                state = "{} {}".format(stat.st_size, stat.st_mtime_ns)
            except OSError:
                state = "missing"
            digest.update("{}\0{}\n".format(os.path.relpath(file, self._path), state).encode("utf-8", "surrogateescape"))
        return digest.hexdigest()
