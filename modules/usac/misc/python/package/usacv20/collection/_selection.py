# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""A selection of pairs of a database, given by a file (--pairs)."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Union

import numpy as np

from ._database import IMAGES, DatabaseSource
from ._pair import CollectionError, Fault, Key, Pair
from ._sqlite import explained

if TYPE_CHECKING:
    import numpy.typing as npt

_PAGE = 500  # number of keys in a query; every version of SQLite allows 999 values


class Selection:
    """A Source of those pairs of a database that are in a list.

    path -- text file in the format of COLMAP's importer of matches and of hloc: two image names on
    each line; empty lines and lines that begin with # are skipped. Names that are not UTF-8 can be
    written with the same bytes as in the database, or with the escapes that the tool prints (see
    _sqlite.decoded). Raises CollectionError if an image is not in the database

    `missing` is the number of listed pairs that have no row in the table of matches. A pickled
    selection has no keys: it is sent to the workers with each chunk, and they only load pairs."""

    def __init__(self, source: DatabaseSource, path: str) -> None:
        self.source = source
        asked = np.unique(np.array(_read(source, path), np.int64))
        found: List[int] = []
        with explained(source.path):
            for begin in range(0, len(asked), _PAGE):
                page = typing.cast(List[int], asked[begin:begin + _PAGE].tolist())
                found += [int(key) for key, in source.connection().execute(
                    "SELECT pair_id FROM matches WHERE pair_id IN ({})".format(", ".join("?" * len(page))), page)]
        self._keys: npt.NDArray[np.int64] = np.sort(np.array(found, np.int64))
        self.missing = len(asked) - len(found)

    def __getstate__(self) -> Dict[str, Any]:
        return dict(self.__dict__, _keys=np.empty(0, np.int64))

    def keys(self) -> typing.Iterator[Key]:
        return iter(typing.cast(List[int], self._keys.tolist()))

    def __len__(self) -> int:
        return len(self._keys)

    def load(self, keys: typing.Sequence[Key]) -> List[Union[Pair, Fault]]:
        return self.source.load(keys)

    def fingerprint(self) -> str:
        return self.source.fingerprint()

    def close(self) -> None:
        self.source.close()


def _read(source: DatabaseSource, path: str) -> List[int]:
    with explained(source.path):
        images: Dict[str, int] = dict(source.connection().execute("SELECT name, image_id FROM images"))
    keys = []
    try:
        with open(path, encoding="utf-8", errors="backslashreplace") as file:  # like names in the database
            for number, line in enumerate(file, 1):
                words = line.strip()
                if words and not words.startswith("#"):
                    keys.append(_key(words, images, "{}: line {}".format(path, number)))
    except OSError as error:
        raise CollectionError("{}: the list of pairs cannot be read: {}".format(path, error.strerror)) from error
    return keys


def _key(line: str, images: Dict[str, int], place: str) -> int:
    """Returns the key of the pair on a line. Names can contain blanks, so each blank is tried as
    the separator until both parts are names of images."""
    numbers: Optional[List[int]] = None
    for i, letter in enumerate(line):
        if letter.isspace():
            first, second = line[:i].rstrip(), line[i:].lstrip()
            if first in images and second in images:
                numbers = sorted((images[first], images[second]))
                break
    if numbers is None:
        unknown = [word for word in line.split() if word not in images]
        raise CollectionError("{}: {}".format(place, "there is no image {} in the database".format(unknown[0]) if unknown and
                                              len(line.split()) == 2 else "two names of images are expected, not {!r}".format(line)))
    if numbers[0] == numbers[1]:
        raise CollectionError("{}: an image has no pair with itself".format(place))
    return numbers[0] * IMAGES + numbers[1]
