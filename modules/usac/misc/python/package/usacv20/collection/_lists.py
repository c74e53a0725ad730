# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The source of the command `pairs`: files of matches, one for each pair, or one file with a group
for each pair.

LIST is one of
- a folder with a file for each pair, including subfolders: `.corr` files with a match on each line,
  `x1 y1 x2 y2 score` (lower scores are better; the score can be missing), and optional `.json`
  files for the sizes and camera matrices of the images (see doc/benchmark.md); or `.npz` files; or
  `.h5` or `.hdf5` files,
- a `.list` file that names such files without extension, one on each line. The names are relative
  to the folder of the list or, if that folder is called `lists`, to its parent folder. A repeated
  name counts once,
- an `.npz` file with arrays PAIR/NAME, or an `.h5` or `.hdf5` file with arrays NAME in groups PAIR
  (for each NAME see below); or such a file with the arrays of a single pair,
- hloc's `.h5` file of matches together with its file of features.

Arrays, all in pixels and without distortion:
- points1, points2 (or mkpts0, mkpts1): N x 2; row i of one array matches row i of the other,
- or keypoints0, keypoints1 (or keypoints1, keypoints2): likewise; or keypoints together with
  matches0 or matches, which contains for each keypoint of image 1 the index of its match (negative:
  no match), or M x 2 indices,
- scores (or matching_scores0, matching_scores, match_confidence, confidence, mconf; higher is
  better) or ratios (lower is better): one for each match, or for each keypoint of image 1,
- K1, K2 (or K0, K1; or K for both images): 3 x 3 camera matrices; without them the focal lengths
  are unknown,
- size1, size2 (or size0, size1; or image_size instead of size): width and height.

Without camera matrices, only F and H can be found. The name of a pair is the path of its file
without the extension, relative to the folder, or its line in the list, or its group."""

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
BATCH = 1 << 16  # number of folder entries that are sorted at once; their names need about ten megabytes


class Container(typing.Protocol):
    """The files of a LIST. ListSource opens them in each process that uses it."""

    def names(self) -> typing.Iterator[str]:
        """Yields the names of all pairs in a fixed order."""

    def files(self) -> typing.Iterable[str]:
        """Returns the paths of all files that pairs come from."""

    def load(self, name: str) -> Pair:
        """Returns the pair of this name. Raises CollectionError if the pair cannot be read."""

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        """Returns the names of the images of a pair; None if they are unknown."""

    def close(self) -> None:
        """Closes all open files."""


def inOrder(entries: Callable[[], typing.Iterable[str]], batch: int) -> typing.Iterator[str]:
    """Yields the strings of `entries`, which must be distinct, in sorted order with only `batch`
    strings in memory: each pass over the entries finds the next `batch` strings."""
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
    """A folder with a file for each pair, all with the same extension in lower or upper case."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._extensions: List[str] = []  # spellings of the extension
        # All files are listed once, in any order, to find their extension, which all files must
        # share.
        for file in self._walk("", self._scanned):
            extension = os.path.splitext(file)[1]
            if extension in self._extensions:
                continue
            if self._extensions and extension.lower() != self._extensions[0].lower():
                fail("{}: has both {} and {} files".format(path, *sorted((extension, self._extensions[0]))))
            self._extensions.append(extension)
        if not self._extensions:
            fail("{}: no {} files".format(path, ", ".join(EXTENSIONS)))
        if len(self._extensions) > 1:
            names = set()
            for name in self.names():
                if name in names:
                    fail("{}: has several files {}, whose extensions differ only in lower and upper case".format(
                        path, name + self._extensions[0].lower()))
                names.add(name)

    def _scanned(self, folder: str) -> typing.Iterator[str]:
        """Yields the files and subfolders of a folder; names of subfolders end in '/'. Links to
        folders are not followed, because they can form a cycle."""
        with os.scandir(os.path.join(self._path, folder)) as entries:
            for entry in entries:
                if entry.name.startswith("."):
                    continue
                if entry.is_dir(follow_symlinks=False):
                    yield entry.name + "/"
                elif entry.name.lower().endswith(EXTENSIONS):
                    yield entry.name

    def _walk(self, folder: str, entries: Callable[[str], typing.Iterable[str]]) -> typing.Iterator[str]:
        """Yields the paths of the files in a folder and its subfolders, relative to the top folder.
        """
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
        paths = [os.path.join(self._path, name + extension) for extension in self._extensions]
        return _loadFile(name, next((path for path in paths[1:] if os.path.exists(path)), paths[0]))

    def images(self, name: str) -> Optional[Tuple[str, str]]:
        return None

    def close(self) -> None:
        pass


class ListFile:
    """A `.list` file, which names the files of the pairs."""

    def __init__(self, path: str) -> None:
        kind = os.path.basename(path)[:-len(".list")].rpartition(".")[2]
        if kind in ("P", "R", "M"):  # lists of absolute poses and 3-D motions
            fail("{}: these are no pairs of images".format(path))
        folder = os.path.dirname(os.path.abspath(path))
        self._path = path
        self._base = os.path.dirname(folder) if os.path.basename(folder) == "lists" else folder
        self._repeated = self._findRepeated()

    def _findRepeated(self) -> typing.Set[str]:
        """Returns the names that occur more than once. Of the other names, only the hashes are kept in
        memory."""
        hashes = np.sort(np.fromiter(map(hash, self._lines()), np.int64))
        repeated = set(hashes[1:][hashes[1:] == hashes[:-1]].tolist())
        return {name for name in self._lines() if hash(name) in repeated} if repeated else set()

    def names(self) -> typing.Iterator[str]:
        seen = set()
        for name in self._lines():
            if name in self._repeated:
                if name in seen:
                    continue
                seen.add(name)
            yield name

    def _lines(self) -> typing.Iterator[str]:
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
    """An NPZ file with arrays PAIR/NAME, or with the arrays of a single pair. The directory of a
    zip file is read as a whole, which needs 1.5 kilobytes of memory for a pair with two arrays. For
    millions of pairs, a folder or an HDF5 file is better."""

    def __init__(self, path: str) -> None:
        self._path = path
        try:
            # numpy.load is not used, because it searches all names at each access.
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
    """A Source of the pairs of a LIST, see the top of this file. `features` is hloc's file of
    features if LIST is hloc's file of matches. Raises CollectionError if LIST does not exist or has
    no pairs."""

    def __init__(self, path: str, features: Optional[str] = None) -> None:
        # The paths are absolute, because workers can run in another folder.
        self._path = os.path.abspath(path)
        self._features = None if features is None else os.path.abspath(features)
        self._opened: Optional[Tuple[int, Container]] = None
        self._count = sum(1 for _ in self.keys())
        if not self._count:
            fail("{}: has no pairs".format(path))

    def __getstate__(self) -> Dict[str, Any]:
        return dict(self.__dict__, _opened=None)

    def _container(self) -> Container:
        """Returns the container, which is opened once in each process: a forked process must not
        share the file positions of its parent."""
        process = os.getpid()
        if self._opened is None or self._opened[0] != process:
            self._opened = process, _open(self._path, self._features)
        return self._opened[1]

    def keys(self) -> typing.Iterator[Key]:
        for name in self._container().names():
            try:
                name.encode("utf-8")
            except UnicodeEncodeError:  # the results could not store this name
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
        """Returns the names of the images of a pair; None if the files do not contain them."""
        return self._container().images(str(key))

    def close(self) -> None:
        """Closes the files that this process has opened; no thread must be using these files. The
        next use opens them again."""
        if self._opened is not None and self._opened[0] == os.getpid():
            self._opened[1].close()
        self._opened = None

    def fingerprint(self) -> str:
        """Returns a fingerprint of the names, sizes and modification times of all files."""
        digest = hashlib.sha256()
        for file in self._container().files():
            try:
                stat = os.stat(file)
                state = "{} {}".format(stat.st_size, stat.st_mtime_ns)
            except OSError:
                state = "missing"
            digest.update("{}\0{}\n".format(os.path.relpath(file, self._path), state).encode("utf-8", "surrogateescape"))
        return digest.hexdigest()
