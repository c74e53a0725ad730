# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Draws pictures of matches with cv2 or, if cv2 cannot be imported, with matplotlib."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _arguments
from ._errors import fail

if TYPE_CHECKING:
    import numpy.typing as npt

    _Image = npt.NDArray[np.uint8]

# Colors that are the same in RGB and BGR order, and that color-blind readers can distinguish.
INLIER, OUTLIER = (0, 170, 0), (230, 0, 230)
RADIUS = 2  # radius of the dots in pixels


def _imported(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def _image(value: Any, name: str) -> _Image:
    """Returns an image as an array of bytes, height x width x 3, in pale gray, so that colored
    lines are visible on it."""
    try:
        given = np.asarray(value)
    except Exception as failure:  # for example, rows have different lengths
        raise fail("{}: an image is expected, height x width with 1, 3 or 4 channels ({})".format(name, failure)) from failure
    channels = given.shape[2] if given.ndim == 3 else 1
    if given.ndim not in (2, 3) or channels not in (1, 3, 4) or given.size == 0 or given.dtype.kind not in "buif":
        raise fail("{}: an image is expected, height x width with 1, 3 or 4 channels, not {}".format(name, _arguments.shown(value)))
    if given.dtype != np.uint8:
        top = 1.0 if given.dtype.kind in "bf" else float(np.iinfo(given.dtype).max)
        given = np.clip(np.nan_to_num(given.astype(np.float64)) * (255 / top), 0, 255)
    gray = given.reshape(given.shape[:2] + (channels,))[..., :3].mean(axis=2)
    return np.repeat((76 + 0.7 * gray).astype(np.uint8)[..., None], 3, axis=2)


def _points(value: Any, name: str) -> npt.NDArray[np.float64]:
    given = _arguments.points(value, name).astype(np.float64)
    if given.ndim == 3:
        given = given.reshape(-1, 2) if given.shape[2] == 2 else given[..., 0]
    if given.ndim == 2 and given.shape[0] == 2 and given.shape[1] != 2:
        given = given.T
    if given.size == 0:
        return np.empty((0, 2))
    if given.ndim != 2 or given.shape[1] != 2:
        raise fail("{}: N points are expected, Nx2, 2xN, Nx1x2 or 1xNx2, not the shape {}".format(name, given.shape))
    return given


def _drawnByCv2(cv2: Any, canvas: _Image, ends: npt.NDArray[np.float64], good: npt.NDArray[np.bool_],
                joined: npt.NDArray[np.bool_]) -> _Image:
    shift = 4  # number of fractional bits of the coordinates, an argument of cv2.line and cv2.circle
    fixed: Any = np.rint(ends * (1 << shift)).astype(int).tolist()
    for (x1, y1, x2, y2), isGood, isJoined in zip(fixed, good, joined):
        color = INLIER if isGood else OUTLIER
        if isJoined:
            cv2.line(canvas, (x1, y1), (x2, y2), color, 1, cv2.LINE_AA, shift)
        for place in ((x1, y1), (x2, y2)):
            cv2.circle(canvas, place, RADIUS << shift, color, -1, cv2.LINE_AA, shift)
    return canvas


def _drawnByMatplotlib(figures: Any, canvas: _Image, ends: npt.NDArray[np.float64], good: npt.NDArray[np.bool_],
                       joined: npt.NDArray[np.bool_]) -> _Image:
    backend = importlib.import_module("matplotlib.backends.backend_agg")
    height, width = canvas.shape[:2]
    dpi = 100
    figure = figures.Figure(figsize=(width / dpi, height / dpi), dpi=dpi)
    agg = backend.FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.axis("off")
    axes.imshow(canvas, interpolation="nearest", aspect="auto", extent=(-0.5, width - 0.5, height - 0.5, -0.5))
    point = 72 / dpi  # size of a pixel in typographic points, 1/72 inch
    for flag, color in ((False, OUTLIER), (True, INLIER)):
        some, tone = ends[good == flag], tuple(value / 255 for value in color)
        lines = ends[(good == flag) & joined]
        axes.plot(lines[:, ::2].T, lines[:, 1::2].T, color=tone, linewidth=point)
        axes.plot(some[:, ::2].ravel(), some[:, 1::2].ravel(), "o", color=tone, markersize=(2 * RADIUS + 1) * point,
                  markeredgewidth=0)
    axes.set_xlim(-0.5, width - 0.5)
    axes.set_ylim(height - 0.5, -0.5)
    agg.draw()
    picture = np.asarray(agg.buffer_rgba())[:height, :width, :3]
    canvas[:picture.shape[0], :picture.shape[1]] = picture
    return canvas


def draw_matches(image1: npt.ArrayLike, image2: npt.ArrayLike, points1: npt.ArrayLike, points2: npt.ArrayLike,
                 mask: Optional[npt.ArrayLike] = None, lines: int = 60) -> _Image:
    """Draws both images side by side in gray, with dots at the matches, green for inliers and
    magenta for outliers, and with lines that join the two points of some inliers. Uses cv2 or
    matplotlib; raises ImportError if there is neither.

        picture = usacv20.draw_matches(image1, image2, points1, points2, mask)
        cv2.imwrite("matches.png", picture)  # or matplotlib.pyplot.imshow(picture)

    image1, image2 -- gray or color images, of integers or of floats from 0 to 1
    points1, points2 -- N points of each image in pixels: Nx2, 2xN, Nx1x2 or 1xNx2; matches with a
    point that is not finite or is far outside its image are not drawn
    mask -- N numbers, nonzero for inliers; None: all matches are inliers
    lines -- maximum number of inliers whose two points are joined by a line; these inliers are
    spread evenly over the list. 0: no lines

    Returns an array of uint8, height x width x 3."""
    first, second = _image(image1, "image1"), _image(image2, "image2")
    places1, places2 = _points(points1, "points1"), _points(points2, "points2")
    count = len(places1)
    if len(places2) != count:
        raise fail("points1 and points2: lists of the same length are expected, not of {} and {}".format(count, len(places2)))
    good = np.ones(count, bool) if mask is None else _arguments.array(mask, "mask").ravel() != 0
    if len(good) != count:
        raise fail("mask: one number for each of the {} matches is expected, not {}".format(count, len(good)))
    most = _arguments.integer(lines, "lines", 60, 0)
    canvas = np.full((max(len(first), len(second)), first.shape[1] + second.shape[1], 3), 255, np.uint8)
    canvas[:len(first), :first.shape[1]] = first
    canvas[:len(second), first.shape[1]:] = second

    ends = np.hstack((places1, places2 + [first.shape[1], 0]))
    # Matches with a point that is not finite or is far outside the picture are not drawn, because
    # fixed-point coordinates would overflow.
    near = (np.abs(np.where(np.isfinite(ends), ends, np.inf)) < 1e5).all(axis=1)
    ends, good = ends[near], good[near]
    joined = np.zeros(len(ends), bool)
    inliers = np.flatnonzero(good)
    joined[inliers[np.unique(np.linspace(0, len(inliers) - 1, min(most, len(inliers))).astype(int))]] = True
    cv2 = _imported("cv2")
    if hasattr(cv2, "circle"):
        return _drawnByCv2(cv2, canvas, ends, good, joined)
    figures = _imported("matplotlib.figure")
    if figures is None:
        raise ImportError("draw_matches: cv2 or matplotlib is needed for pictures (pip install opencv-python or matplotlib; "
                          "Debian: python3-opencv, python3-matplotlib)")
    return _drawnByMatplotlib(figures, canvas, ends, good, joined)
