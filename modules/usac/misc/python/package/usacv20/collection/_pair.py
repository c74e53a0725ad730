# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""What the parts of the tool hand to each other: pairs of images with their matches, and what has become of them."""

from __future__ import annotations

import enum
import typing
from typing import TYPE_CHECKING, List, Optional, Union

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

Key = Union[int, str]  # of a pair: COLMAP's pair_id in a database, a name in a list


class CollectionError(Exception):
    """Raised, with one line for the user, if the tool cannot go on or a pair cannot be used."""


class Configuration(enum.IntEnum):
    """The relation between two images that their matches show, with COLMAP's numbers."""

    UNDEFINED = 0
    DEGENERATE = 1
    CALIBRATED = 2
    UNCALIBRATED = 3
    PLANAR = 4
    PANORAMIC = 5
    PLANAR_OR_PANORAMIC = 6
    WATERMARK = 7
    MULTIPLE = 8  # this and the next are in tables of COLMAP's own only
    CALIBRATED_RIG = 9


class View(typing.NamedTuple):
    """One side of a pair: the matched points of an image and its camera."""

    name: str
    points: npt.NDArray[np.float64]  # M x 2, pixels, as a camera without distortion sees them
    taken: npt.NDArray[np.float64]  # M x 2, pixels in the image as taken; the same array if there is no distortion
    matrix: npt.NDArray[np.float64]  # 3 x 3
    focalKnown: bool
    width: int  # pixels; 0: not known
    height: int


class Pair(typing.NamedTuple):
    """Two images and their matches; row i of the points of both views is match i."""

    key: Key
    first: View
    second: View
    matches: npt.NDArray[np.uint32]  # M x 2: numbers of the keypoints
    scores: Optional[npt.NDArray[np.float64]]  # M, of the matches; None: not known
    higherIsBetter: bool


class Fault(typing.NamedTuple):
    """A pair that cannot be read, in the place of a Pair."""

    key: Key
    reason: str  # one line that names the images


class TwoView(typing.NamedTuple):
    """The result for a pair."""

    key: Key
    configuration: Configuration  # UNDEFINED: a fault
    inliers: npt.NDArray[np.uint32]  # K x 2: rows of Pair.matches
    F: Optional[npt.NDArray[np.float64]]  # 3 x 3, of points without distortion; None: not estimated or not found
    E: Optional[npt.NDArray[np.float64]]
    H: Optional[npt.NDArray[np.float64]]
    quaternion: Optional[npt.NDArray[np.float64]]  # w, x, y, z: x2 ~ R x1 + t; None: not known
    translation: Optional[npt.NDArray[np.float64]]  # unit length; 0: a rotation
    reason: str  # why the pair is refused, one line; empty: it is not
    matches: int
    iterations: int  # samples drawn, except for H among the inliers of E or F
    chance: float  # Report.chance of the model that was taken
    milliseconds: float
    # k x 4, as `quaternion`: those that the matches allow, one of which is right. None: the focal lengths are not known
    rotations: Optional[npt.NDArray[np.float64]] = None


class Source(typing.Protocol):
    """Base class of sources of pairs. Objects can be pickled; each process opens the files by itself when it needs them first."""

    def keys(self) -> typing.Iterator[Key]:
        """Returns the keys of all pairs in a fixed order, as a stream."""

    def __len__(self) -> int:
        """Returns the number of pairs."""

    def load(self, keys: typing.Sequence[Key]) -> List[Union[Pair, Fault]]:
        """Returns pairs in the order of the keys."""

    def fingerprint(self) -> str:
        """Returns a text that is the same in two processes that see the same files."""


class Sink(typing.Protocol):
    """Base class of sinks, which store results; one thread only uses a sink."""

    def done(self, key: Key) -> bool:
        """Returns True if an earlier run has stored the pair (--resume)."""

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        """Stores results at once, or none of them."""

    def close(self, finished: bool = True) -> None:
        """Ends the sink: nothing is stored afterwards. finished -- False: pairs are left for --resume."""
