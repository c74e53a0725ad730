# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The data types that the parts of the tool share: pairs of images with their matches, and results.
"""

from __future__ import annotations

import enum
import typing
from typing import TYPE_CHECKING, List, Optional, Union

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

Key = Union[int, str]  # id of a pair: COLMAP's pair_id in a database, a name in a list


class CollectionError(Exception):
    """Raised if the tool cannot continue, or if a pair cannot be used. The message is one line for
    the user."""


class Configuration(enum.IntEnum):
    """The relation between two images according to their matches, with COLMAP's numbers."""

    UNDEFINED = 0
    DEGENERATE = 1
    CALIBRATED = 2
    UNCALIBRATED = 3
    PLANAR = 4
    PANORAMIC = 5
    PLANAR_OR_PANORAMIC = 6
    WATERMARK = 7
    MULTIPLE = 8  # MULTIPLE and CALIBRATED_RIG occur only in tables written by COLMAP
    CALIBRATED_RIG = 9


class View(typing.NamedTuple):
    """The matched points of one image of a pair, and the camera of this image."""

    name: str
    points: npt.NDArray[np.float64]  # M x 2, pixels, without distortion
    taken: npt.NDArray[np.float64]  # M x 2, pixels of the original image; `points` itself if the image has no distortion
    matrix: npt.NDArray[np.float64]  # 3 x 3 camera matrix
    focalKnown: bool  # False: the focal length in `matrix` is a guess
    width: int  # pixels; 0: unknown
    height: int


class Pair(typing.NamedTuple):
    """Two images and their matches; row i of the points of both views is match i."""

    key: Key
    first: View
    second: View
    matches: npt.NDArray[np.uint32]  # M x 2: indices of the keypoints in both images
    scores: Optional[npt.NDArray[np.float64]]  # M scores of the matches; None: there are no scores
    higherIsBetter: bool  # True: matches with higher scores are better
    matchesHash: Optional[int] = None  # hash of the matches as they are stored in a database; None: not from a database


class Fault(typing.NamedTuple):
    """Replaces a Pair that cannot be read."""

    key: Key
    reason: str  # one line that names the pair or its images


class TwoView(typing.NamedTuple):
    """The result for a pair."""

    key: Key
    configuration: Configuration  # UNDEFINED: the pair is a fault
    inliers: npt.NDArray[np.uint32]  # K x 2: the rows of Pair.matches that are inliers
    F: Optional[npt.NDArray[np.float64]]  # 3 x 3, for points without distortion; None: not estimated or not found
    E: Optional[npt.NDArray[np.float64]]  # 3 x 3, for normalized image planes; None: not estimated or not found
    H: Optional[npt.NDArray[np.float64]]  # 3 x 3, for points without distortion; None: not estimated or not found
    quaternion: Optional[npt.NDArray[np.float64]]  # w, x, y, z: rotation R of the motion X2 = R X1 + t; None: unknown
    translation: Optional[npt.NDArray[np.float64]]  # t, unit length; 0: pure rotation; None: unknown
    reason: str  # why the pair is refused or a fault, one line; empty: the pair is accepted
    matches: int  # number of matches of the pair
    iterations: int  # number of samples drawn, not counting those from which H was estimated among the inliers of E or F
    chance: float  # Report.chance of the accepted model or, for a refused pair, of the best rejected model
    milliseconds: float
    # k x 4, in the form of `quaternion`: the k rotations compatible with the matches; if the matches
    # are correct, one of the k rotations is the true one. None: unknown, for example because the
    # focal lengths are unknown.
    rotations: Optional[npt.NDArray[np.float64]] = None
    matchesHash: Optional[int] = None  # that of the Pair; None: unknown


class Source(typing.Protocol):
    """Interface of sources of pairs. Sources must be picklable; each process opens the files of a
    source itself at their first use."""

    def keys(self) -> typing.Iterator[Key]:
        """Yields the keys of all pairs in a fixed order."""

    def __len__(self) -> int:
        """Returns the number of pairs."""

    def load(self, keys: typing.Sequence[Key]) -> List[Union[Pair, Fault]]:
        """Returns the pairs in the order of the keys; a Fault replaces a pair that cannot be read.
        """

    def fingerprint(self) -> str:
        """Returns a text that is equal in two processes if both see the same files."""


class Sink(typing.Protocol):
    """Interface of sinks, which store results. A sink is used by one thread only."""

    def done(self, key: Key) -> bool:
        """Returns True if an earlier run has processed the pair and --resume can skip the pair."""

    def commit(self, results: typing.Sequence[TwoView]) -> None:
        """Stores all of the results or none of them."""

    def close(self, finished: bool = True) -> None:
        """Ends the sink; nothing can be stored afterwards.

        finished -- False: some pairs are not done, and --resume can process them later"""
