# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The command `report`, which describes the results for a collection as text, JSON, CSV and
pictures.

It lists some pairs that should be checked, the first few of each kind:
- refused pairs with the most matches,
- verified pairs whose chance (the probability that random matches give a result as good) is at
  least a hundredth of the limit (Settings.significance), those with the largest chance first,
- verified pairs with an inlier ratio below 0.2, those with the most inliers first; possible reasons
  are repeated structure and a moving part of the images,
- pairs that are the only link between two parts of at least two images each, sorted by the number of
  images of the smaller part, in descending order. If such a pair is wrong, it joins unrelated parts
  of the reconstruction; if it were missing, the reconstruction would fall apart."""

from __future__ import annotations

import csv
import json
import typing
from typing import Any, Dict, List, Optional

from . import _pictures
from ._output import write
from ._pair import CollectionError, Configuration
from ._report_graph import Graph, graphOf, indexed
from ._report_table import FAULT, OURS, PAIRS, REFUSED, VERIFIED, Results, Row
from ._settings import Settings
from ._sqlite import focalNote

LOW_RATIO = 0.2  # verified pairs with a smaller inlier ratio are listed
NEAR_LIMIT = 0.01  # verified pairs are listed if their chance is at least this fraction of the limit
REASONS = 20  # maximum number of listed reasons; reasons that differ only in numbers count as one
QUANTILES = (0.5, 0.9, 1.0)
_STEPS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000)


class Measure(typing.NamedTuple):
    """A value of pairs that the report shows as a histogram."""

    name: str
    title: str
    value: str  # SQL expression for a row
    edges: typing.Sequence[float]  # edges of the bins
    where: str  # SQL condition for the rows


MEASURES = (
    Measure("inlierRatio", "inlier ratio of verified pairs", "(inliers * 1.0 / matches)", [i / 10 for i in range(11)],
            "state = {} AND matches > 0".format(VERIFIED)),
    Measure("iterations", "samples of a pair, sum over all models", "iterations", (0,) + _STEPS, "state != {}".format(FAULT)),
    Measure("milliseconds", "milliseconds of a pair", "milliseconds", [0.0] + [step / 100 for step in _STEPS[2:]] + [1000.0],
            "state != {}".format(FAULT)))


def _significance(settings: Any) -> float:
    """Returns the limit of the chance from the settings of a run, which can be nested dictionaries;
    the default limit if the settings do not contain it."""
    if isinstance(settings, dict):
        for name, value in settings.items():
            if name == "significance" and isinstance(value, (int, float)):
                return float(value)
            if isinstance(value, dict) and "significance" in value:
                return _significance(value)
    return Settings().significance


def _named(row: Row) -> Dict[str, Any]:
    return {"pair": row.name, "configuration": row.configuration.name, "reason": row.reason, "matches": row.matches,
            "inliers": row.inliers, "chance": row.chance}


def _look(results: Results, graph: Optional[Graph], images: Any, limit: float, most: int) -> List[Dict[str, Any]]:
    verified = "state = {} AND ".format(VERIFIED)
    kinds = [
        ("refused, with the most matches", results.pairs(
            "state = {} AND matches > 0".format(REFUSED), "matches DESC, name", most)),
        ("verified, with a chance near the limit of {:g}".format(limit), results.pairs(
            verified + "chance >= {!r}".format(NEAR_LIMIT * limit), "chance DESC, name", most)),
        ("verified, many inliers, but an inlier ratio below {:g}".format(LOW_RATIO), results.pairs(
            verified + "inliers < {!r} * matches".format(LOW_RATIO), "inliers DESC, name", most))]
    found: List[Dict[str, Any]] = [dict(_named(row), kind=kind) for kind, rows in kinds for row in rows]
    for bridge in [] if graph is None else [bridge for bridge in graph.bridges if bridge.images > 1][:most]:
        row = results.pairOf(int(images[bridge.first]), int(images[bridge.second]))
        if row is not None:
            found.append(dict(_named(row), kind="the only link between two parts", images=bridge.images))
    return found


def summarize(results: Results, most: int = 5) -> Dict[str, Any]:
    """Returns all numbers and lists of a report, as in its JSON file."""
    states: Dict[int, int] = dict((state, count) for state, count in results.rows(
        "SELECT state, COUNT(*) FROM results GROUP BY state"))
    if not states:
        raise CollectionError("{}: no pair has been verified yet".format(results.path))
    summary: Dict[str, Any] = {
        "file": results.path, "source": results.kind, "pairs": sum(states.values()), "verified": states.get(VERIFIED, 0),
        "refused": states.get(REFUSED, 0), "faults": states.get(FAULT, 0), "left": results.left(), "changed": results.changed(),
        "configurations": {}, "reasons": [], "histograms": {}}
    known = {int(configuration): configuration.name for configuration in Configuration}
    for number, count in results.rows("SELECT configuration, COUNT(*) FROM results GROUP BY 1 ORDER BY 1"):
        summary["configurations"][known.get(number, str(number))] = count
    if results.kind in (OURS, PAIRS):
        summary["reasons"] = [dict(zip(("reason", "pairs", "example"), row)) for row in results.reasons(REASONS)]
    for measure in MEASURES:
        quantiles = results.quantiles(measure.value, QUANTILES, measure.where)
        if quantiles:
            summary["histograms"][measure.name] = {
                "title": measure.title, "edges": list(measure.edges), "quantiles": quantiles,
                "pairs": results.histogram(measure.value, measure.edges, measure.where)}
    summary["milliseconds"] = results.value("SELECT SUM(milliseconds) FROM results")
    summary["iterations"] = results.value("SELECT SUM(iterations) FROM results")
    summary["knownCameras"], summary["cameras"] = results.cameras()
    images = results.images()
    graph = None
    if len(images):
        links = indexed(images, results.links("state = {}".format(VERIFIED)))
        graph = graphOf(len(images), ((int(row[0]), int(row[1])) for block in links for row in block))
        summary["images"] = len(images)
        summary["components"] = {"all": len(graph.components), "largest": graph.components[:most],
                                 "single": graph.components.count(1)}
        summary["bridges"] = len(graph.bridges)
    summary["look"] = _look(results, graph, images, _significance(results.settings()), most)
    return summary


def _table(rows: typing.Iterable[typing.Sequence[Any]], indent: str = "  ") -> List[str]:
    """Returns lines with columns of equal width; numbers are aligned to the right."""
    cells = [[cell if isinstance(cell, str) else _number(cell) for cell in row] for row in rows]
    given = [list(row) for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]))] if cells else []
    return [(indent + "  ".join(text.ljust(width) if isinstance(value, str) else text.rjust(width)
                                for text, value, width in zip(row, values, widths))).rstrip()
            for row, values in zip(cells, given)]


def _number(value: Any) -> str:
    if value is None:
        return ""
    return str(value) if isinstance(value, int) else "{:.3g}".format(value)


def _share(count: int, total: int) -> str:
    return "{:.1f} %".format(100 * count / total if total else 0)


def _textOfCounts(summary: Dict[str, Any]) -> List[str]:
    total = summary["pairs"]
    lines = ["{}: {} pairs".format(summary["file"], total)]
    rows = [[name, summary[key], _share(summary[key], total)] for name, key in (
        ("verified", "verified"), ("refused", "refused"), ("cannot be read", "faults"))]
    lines += _table(rows)
    if summary["left"]:
        lines.append("  {} more pairs have not been processed yet".format(summary["left"]))
    if summary["changed"]:
        lines.append("  {} rows of two_view_geometries are not of this run, but of another program or an earlier run".format(
            summary["changed"]))
    note = focalNote(summary["knownCameras"], summary["cameras"])
    if note:
        lines.append("  " + note)
    lines += ["", "Configurations"] + _table([[name, count, _share(count, total)]
                                               for name, count in summary["configurations"].items()])
    if summary["reasons"]:
        lines += ["", "Reasons (N: a number)"] + _table([[row["pairs"], row["reason"], "for example " + row["example"]]
                                                         for row in summary["reasons"]])
    if "images" in summary:
        components = summary["components"]
        lines += ["", "Images", "  {} images, {} of them without a verified pair".format(summary["images"], components["single"]),
                  "  {} connected components of at least two images; images in the largest components: {}".format(
                      components["all"] - components["single"], ", ".join(map(str, components["largest"]))),
                  "  {} verified pairs are the only link between the two parts that they connect".format(summary["bridges"])]
    return lines


def _textOfHistograms(summary: Dict[str, Any]) -> List[str]:
    lines: List[str] = []
    for histogram in summary["histograms"].values():
        counts, edges = histogram["pairs"], histogram["edges"]
        lines += ["", "{}: median {:.3g}, 90 % below {:.3g}, largest {:.3g}".format(
            histogram["title"][0].upper() + histogram["title"][1:], *histogram["quantiles"])]
        rows = [["{:g} to {:g}".format(edges[i], edges[i + 1]), count, _share(count, sum(counts)),
                 "#" * round(40 * count / max(counts))] for i, count in enumerate(counts) if count]
        lines += _table(rows)
    if summary["iterations"] is not None and summary["milliseconds"] is not None:
        seconds = summary["milliseconds"] / 1000
        lines += ["", "In total, {} samples and {:.3g} s of estimation".format(summary["iterations"], seconds)]
    return lines


def textOf(summary: Dict[str, Any]) -> str:
    """Returns the text of a report, for a terminal."""
    lines = _textOfCounts(summary) + _textOfHistograms(summary)
    if summary["look"]:
        lines += ["", "Pairs that should be checked"]
    for kind in dict.fromkeys(pair["kind"] for pair in summary["look"]):
        lines.append("  " + kind)
        lines += _table([[pair["pair"], "{} of {}".format(pair["inliers"], pair["matches"]),
                          "" if pair["chance"] is None or pair["reason"] else "chance {:.2g}".format(pair["chance"]),
                          pair["reason"] or pair["configuration"],
                          "smaller part: {} images".format(pair["images"]) if "images" in pair else ""]
                         for pair in summary["look"] if pair["kind"] == kind], "    ")
    return "\n".join(lines) + "\n"


def _writeTable(results: Results, path: str) -> None:
    with open(path, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        writer.writerow(("pair", "configuration", "reason", "matches", "inliers", "iterations", "chance", "milliseconds"))
        for row in results.pairs():
            writer.writerow((row.name, row.configuration.name, row.reason, row.matches, row.inliers, row.iterations, row.chance,
                             row.milliseconds))


def report(path: str, pictures: Optional[str] = None, jsonFile: Optional[str] = None, csvFile: Optional[str] = None,
           most: int = 5, stream: Optional[typing.TextIO] = None) -> int:
    """Reports on a COLMAP database or on a database of the command `pairs`; the file is not
    changed.

    pictures -- folder for histograms and the matrix of the pairs; None: no pictures
    jsonFile -- file for the numbers; csvFile -- file with a row for each pair; None: not written
    most -- maximum number of listed pairs of each kind that should be checked
    stream -- output stream for the text; None: standard output

    Returns the exit code. Raises CollectionError if the file has no results, or if a file cannot be
    read or written."""
    draw = None if pictures is None else _pictures.Pictures(pictures)  # first, so that a missing library is reported early
    try:
        with Results(path) as results:
            summary = summarize(results, most)
            write(textOf(summary), stream)
            if draw is not None:
                draw.histograms(summary["histograms"])
                draw.pairs(results)
            if jsonFile is not None:
                with open(jsonFile, "w", encoding="utf-8") as out:
                    json.dump(summary, out, indent=1)
                    out.write("\n")
            if csvFile is not None:
                _writeTable(results, csvFile)
    except OSError as error:
        raise CollectionError("{}: {}".format(error.filename or path, error.strerror)) from error
    return 0
