# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Pictures of the command `report`; they need matplotlib."""

from __future__ import annotations

import os
import typing
from typing import TYPE_CHECKING, Any, Dict

import numpy as np

from ._optional import need
from ._pair import CollectionError
from ._report_graph import indexed, matrixOf
from ._report_table import VERIFIED, Results

if TYPE_CHECKING:
    import numpy.typing as npt

    _Numbers = npt.NDArray[np.int64]

CELLS = 1000  # maximum number of rows and columns of the matrix of pairs
NAMED = 40  # maximum number of images whose names are shown next to the matrix; with more images, the rows are too narrow


def _ranked(blocks: typing.Iterable[_Numbers], ranks: _Numbers) -> typing.Iterator[_Numbers]:
    """Yields blocks of links in which each image index i is replaced by ranks[i]."""
    for block in blocks:
        yield np.column_stack((ranks[block[:, :2]], block[:, 2:]))


class Pictures:
    """Draws PNG files in a folder: a histogram of each measure, `<name>.png`, and `pairs.png`."""

    def __init__(self, folder: str) -> None:
        """Creates the folder. Raises CollectionError if this fails, or if matplotlib is missing."""
        # pyplot is not used, because it can require a display and keeps all figures in memory.
        self._figure = need("matplotlib.figure", "for --pictures").Figure
        self._canvas = need("matplotlib.backends.backend_agg", "for --pictures").FigureCanvasAgg
        self._colors = need("matplotlib.colors", "for --pictures")
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise CollectionError("--pictures {}: this folder cannot be created: {}".format(folder, error.strerror)) from error
        self._folder = folder

    def _new(self, width: float, height: float) -> Any:
        figure = self._figure(figsize=(width, height), dpi=100, constrained_layout=True)
        self._canvas(figure)
        return figure

    def histograms(self, histograms: Dict[str, Any]) -> None:
        """Draws the histograms in the summary of a report. All bars have equal width, although in some
        histograms the bins of larger values are wider."""
        for name, histogram in histograms.items():
            figure = self._new(8, 4.5)
            axes = figure.add_subplot()
            used = np.flatnonzero(histogram["pairs"])
            begin, end = int(used[0]), int(used[-1]) + 1  # removes empty bins at both ends
            counts, edges = histogram["pairs"][begin:end], histogram["edges"][begin:end + 1]
            axes.bar(range(len(counts)), counts, width=0.95, align="edge", color="tab:blue")
            axes.set_xticks(range(len(edges)))
            axes.set_xticklabels(["{:g}".format(edge) for edge in edges])
            axes.set_xlabel(histogram["title"])
            axes.set_ylabel("pairs")
            axes.set_title("median {:.3g}, 90 % below {:.3g}, largest {:.3g}".format(*histogram["quantiles"]))
            figure.savefig(os.path.join(self._folder, name + ".png"))

    def pairs(self, results: Results) -> None:
        """Draws the matrix of the pairs: colors show the number of inliers, gray shows refused
        pairs, white shows pairs without matches. Draws nothing if the results do not contain the
        images."""
        images = results.images()
        if not len(images):
            return
        names, ranks = results.names(images)
        cells = matrixOf(len(images), _ranked(indexed(images, results.links()), ranks), VERIFIED, CELLS)
        figure = self._new(9, 8)
        axes = figure.add_subplot()
        axes.set_facecolor("white")
        extent = (0.5, len(images) + 0.5, len(images) + 0.5, 0.5)
        gray = self._colors.ListedColormap(["lightgray"])
        axes.imshow(np.where(cells == -1, 1.0, np.nan), cmap=gray, extent=extent, interpolation="nearest")
        found = cells[cells > 0]
        scale = self._colors.LogNorm(found.min() if len(found) else 1, found.max() + 1 if len(found) else 2)
        colored = np.where(cells > 0, cells, np.nan)
        shown = axes.imshow(colored, norm=scale, cmap="viridis", extent=extent, interpolation="nearest")
        figure.colorbar(shown, ax=axes, label="inliers; gray: refused, white: not matched")
        if len(images) <= NAMED:
            places = range(1, len(images) + 1)
            axes.set_xticks(places)
            axes.set_xticklabels(names, rotation=90, fontsize=7)
            axes.set_yticks(places)
            axes.set_yticklabels(names, fontsize=7)
        axes.set_xlabel("image, in the order of the names")
        axes.set_ylabel("image")
        share = -(-len(images) // len(cells))
        shared = ", up to {} in a row: the most inliers".format(share) if share > 1 else ""
        axes.set_title("{} images{}".format(len(images), shared))
        figure.savefig(os.path.join(self._folder, "pairs.png"))
