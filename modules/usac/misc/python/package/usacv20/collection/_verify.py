# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Verification of a whole database, for the command line and for other programs."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import sqlite3
import time
import typing
from typing import Any, Callable, Dict, Optional, Tuple, Union

from .._enumerations import UsacV20Method
from ._database import DatabaseSource
from ._database_sink import DatabaseSink, lastRun
from ._engine import CHUNK, Summary, checkNumbers, run
from ._geometry import verifyPairs
from ._loops import contradicted
from ._pair import CollectionError, Source
from ._scores import ColumnScores, HlocScores
from ._selection import Selection
from ._settings import Settings
from ._sqlite import connect, copied, explained, focalNote, knownCameras
from ._threshold import WIDEST, estimateThreshold, samplePairs

Say = Callable[[str], Any]


def verify(path: str, output: Optional[str] = None, *, threshold: Optional[float] = None, pairs: Optional[str] = None,
           resume: bool = False, scores: Union[HlocScores, ColumnScores, None] = None, loops: bool = True, threads: int = 0, workers: int = 0,
           scheduler: str = "", chunk: int = CHUNK, progress: Optional[bool] = False, say: Optional[Say] = None,
           **settings: Any) -> Summary:
    """Estimates the two-view geometry of all pairs of a COLMAP database, as `usacv20-collection
    verify` does.

    path -- path of the database. Of COLMAP's tables, only two_view_geometries is written
    output -- path of a copy that is made and written instead; with `resume` the copy can exist
    already, and its images, keypoints and matches must be those of the database
    threshold -- maximum error of an inlier in pixels. None: estimated from a sample of the pairs
    or, with `resume`, equal to the threshold of the last run. With the method USACV20_AUTO each
    pair has its own threshold, and this value is the upper limit, 12 by default
    pairs -- file with two image names on each line: only these pairs are verified, and rows of
    other pairs do not change
    resume -- True: pairs that a run with the same settings has processed are skipped, except for
    pairs that could not be read, pairs that were refused because they contradict other pairs, and
    pairs whose matches or results another program has changed
    scores -- source of the scores of the matches; None: there are no scores
    loops -- False: pairs whose rotation contradicts that of pairs with more inliers are not refused
    threads -- number of threads of this process; 0: one for each core
    workers, scheduler -- for Dask: number of processes to start on this machine, or the address of
    a running scheduler, tcp://HOST:PORT
    chunk -- number of pairs that are estimated and stored together; at least 1
    progress -- True: shows a progress bar on stderr; False: no bar; None: a bar only if stderr is a
    terminal
    say -- function that is called with each line that the command prints
    settings -- method, confidence, maxIterations, inlierRatio, minInliers, significance,
    watermarks, seed: as on the command line

    Returns the summary of the run. Pairs that cannot be read are counted in the summary, and the
    first 20 of these pairs are named on stderr. Raises CollectionError if the run cannot start or
    continue, and KeyboardInterrupt if the run was interrupted, after the results of the pairs in
    progress are stored."""
    summary = verifyDatabase(path, output, threshold, pairs, resume, scores, loops, settings, say or _silent, threads=threads,
                             workers=workers, scheduler=scheduler, chunk=chunk, progress=progress)
    if summary.interrupted:
        raise KeyboardInterrupt
    return summary


def _silent(line: str) -> None:
    pass


def verifyDatabase(path: str, output: Optional[str], threshold: Optional[float], pairs: Optional[str], resume: bool, scores: Any, loops: bool,
                   options: Dict[str, Any], say: Say, **engine: Any) -> Summary:
    """Does the same as `verify`, but reports an interruption in the summary."""
    checkNumbers(**engine)
    with contextlib.closing(DatabaseSource(path, scores)) as source:
        _checkMatches(source)
        _checkColumn(source)
        with explained(path):
            note = focalNote(*knownCameras(source.connection()))
        if note:
            say(note)
        chosen: Any = source
        if pairs is not None:
            chosen = Selection(source, pairs)
            if chosen.missing:
                say("{} pairs of {} have no matches in the database".format(chosen.missing, pairs))
            if not len(chosen):
                raise CollectionError("{}: none of its pairs has matches in the database: run a matcher first".format(pairs))
        # The copy to make; None: the database itself is written, or an existing copy is continued.
        copy = None if resume and os.path.exists(output or "") else output
        if output and not copy:
            _checkCopy(source, output)
        stored = _stored(path if copy else output or path) if resume else None
        settings = settle(source, threshold, options, stored, say)
        described = scores.describe((stored or {}).get("scores")) if scores else None
        used = dict(settings.asDict(), scores=described, loops=bool(loops))
        with copied(path, copy):
            sink = DatabaseSink(output or path, used, resume, keep=pairs is not None)
        summary = go(chosen, sink, settings, say, sink if loops else None, pairs is not None, **engine)
    summary.threshold = settings.threshold
    if sink.replaced:
        say("{} rows that were in two_view_geometries are replaced".format(sink.replaced))
    return summary


def settle(source: Source, threshold: Optional[float], options: Dict[str, Any], stored: Optional[typing.Mapping[str, Any]],
           say: Say) -> Settings:
    """Returns the settings with a threshold and, for the number of samples, the inlier ratios of some pairs.

    source -- source of all pairs of the collection, even if only some pairs are verified, so that
    the threshold does not depend on the selection
    threshold -- None: the threshold in `stored`, or else a threshold estimated from a sample of the
    pairs; with USACV20_AUTO each pair has its own threshold
    stored -- the settings of the run that is continued; None: no run is continued"""
    unknown = sorted(set(options) - set(Settings().asDict()))
    if unknown:
        raise CollectionError("{}: there is no such setting".format(unknown[0]))
    settings = Settings(**options) if threshold is None else Settings(threshold=threshold, **options)
    before = (stored or {}).get("threshold")
    ratios: Tuple[float, ...] = ()
    if isinstance(before, (int, float)):
        found, told = float(before), "{:g} px, that of the run that is continued".format(before)
        ratios = tuple((stored or {}).get("ratios") or ())
    elif settings.method == UsacV20Method.USACV20_AUTO.name:
        found, told = WIDEST, "of each pair from its own matches, at most {:g} px".format(WIDEST)
    else:
        estimate = estimateThreshold(samplePairs(source), settings)
        found, told, ratios = estimate.threshold, estimate.describe(), estimate.ratios
    if threshold is not None:
        return dataclasses.replace(settings, ratios=ratios)
    say("threshold: " + told)
    return dataclasses.replace(settings, threshold=found, ratios=ratios)


def go(source: Source, sink: Any, settings: Settings, say: Say, graph: Optional[DatabaseSink] = None, some: bool = False,
       **engine: Any) -> Summary:
    """Runs the estimation, closes the sink and returns the summary.

    graph -- the sink, if pairs that contradict other pairs must be refused; otherwise None
    some -- True: only pairs of the source are refused, because rows of other pairs must not change"""
    finished = False
    try:
        summary = run(source, sink, settings, verifyPairs, **engine)
        finished = not summary.interrupted
        if finished and graph is not None:
            _refuseContradicted(graph, summary, source if some else None)
    finally:
        sink.close(finished)
    say(summary.line())
    say(summary.times())
    return summary


def _refuseContradicted(graph: DatabaseSink, summary: Summary, only: Optional[Source]) -> None:
    start = time.perf_counter()
    wrong = contradicted(graph.edges())
    if only is not None and wrong:
        wrong = {key: wrong[key] for key in only.keys() if key in wrong}
    if wrong:
        summary.refused += graph.refuse({key: "the rotation differs by {:.0f} degrees from that along a path of pairs with more "
                                              "inliers".format(degrees)
                                         for key, degrees in wrong.items()})
    summary.contradicted = len(wrong)
    summary.writing += time.perf_counter() - start


def _stored(path: str) -> Optional[Dict[str, Any]]:
    """Returns the settings of the last run on a database; None if there was no run."""
    with explained(path), contextlib.closing(connect(path)) as connection:
        last = lastRun(connection)
    return last["settings"] if last else None


def _checkCopy(source: DatabaseSource, path: str) -> None:
    """Raises CollectionError if the copy that a run continues seems to have other images, keypoints or
    matches than the database, for example because the database has grown since it was copied: the
    pairs of the database would be verified, but the copy would be written."""
    with contextlib.closing(DatabaseSource(path, source.scores)) as copy:
        theirs = copy.counts()
        differing = [name for name, count in source.counts().items() if theirs[name] != count]
        if not differing and copy.fingerprint() != source.fingerprint():
            differing = ["contents"]
    if differing:
        raise CollectionError("{}: --resume: the {} of this copy are not those of {}: name another file as output to begin anew, "
                              "or verify the copy itself, without an output, to continue with its contents".format(
                                  path, differing[0], source.path))


def _checkMatches(source: DatabaseSource) -> None:
    with explained(source.path):
        if not source.connection().execute("SELECT 1 FROM matches WHERE rows > 0 LIMIT 1").fetchall():
            raise CollectionError("{}: no pair has matches: run a matcher first, colmap exhaustive_matcher, say".format(source.path))


def _checkColumn(source: DatabaseSource) -> None:
    """Raises CollectionError if the scores are to be read from a column that does not exist."""
    if not isinstance(source.scores, ColumnScores):
        return
    with explained(source.path):
        try:
            source.connection().execute('SELECT matches."{}" FROM matches LIMIT 0'.format(source.scores.column))
        except sqlite3.OperationalError as error:
            if "no such column" not in str(error):
                raise
            raise CollectionError("--scores-column: the table matches of {} has no column {}".format(
                source.path, source.scores.column)) from error
