# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The command line of the collection tool."""

from __future__ import annotations

import argparse
import contextlib
import sys
import typing
from typing import Any, Dict, Optional

from ._engine import CHUNK, Summary
from ._output import say
from ._pair import CollectionError
from ._scores import ColumnScores, HlocScores
from ._settings import METHODS, Settings
from ._verify import go, settle, verifyDatabase

DONE, FAULTS, MISTAKE, INTERRUPTED = 0, 1, 2, 130

_EPILOG = """exit code: 0 all pairs are done (refused ones, too); 1 some cannot be read, each is named on a line; 2 nothing could
be done; 130 interrupted: what was done is stored, --resume goes on"""


def _threshold(text: str) -> Optional[float]:
    if text == "auto":
        return None
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError("auto or a number of pixels is expected, not {!r}".format(text))


def _count(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        number = -1
    if number < 0:
        raise argparse.ArgumentTypeError("a number from 0 on is expected, not {!r}".format(text))
    return number


def _addEstimation(parser: argparse.ArgumentParser) -> None:
    default = Settings()
    group = parser.add_argument_group("estimation")
    group.add_argument("--threshold", type=_threshold, default=None, metavar="PIXELS",
                       help="largest error of an inlier, or auto (default): found from a part of the pairs, with --resume that of "
                            "the run that goes on; with --method USACV20_AUTO the largest plausible one")
    group.add_argument("--method", choices=sorted(METHODS), default=default.method, help="preset (default %(default)s)")
    group.add_argument("--confidence", type=float, default=default.confidence, help="default %(default)s")
    group.add_argument("--max-iterations", type=_count, default=default.maxIterations, metavar="N",
                       help="samples of a model (default %(default)s); where that is too few for --confidence the reason of a "
                            "refused pair says so")
    group.add_argument("--min-inlier-ratio", type=float, default=default.inlierRatio, metavar="PART",
                       help="of the matches: what --confidence is for; bounds the samples (default %(default)s)")
    group.add_argument("--min-inliers", type=_count, default=default.minInliers, metavar="N",
                       help="of a pair that is kept (default %(default)s)")
    group.add_argument("--significance", type=float, default=default.significance, metavar="CHANCE",
                       help="chance with which random matches would give as good a pair: of pairs without overlap whose matches are "
                            "random at most this part is kept, more of those whose wrong matches agree, as repeated structure has "
                            "them (default %(default)s)")
    group.add_argument("--no-watermarks", action="store_true", help="do not look for pairs that share a mark or frame only")
    group.add_argument("--seed", type=int, default=default.seed, help="of the pseudo-random samples (default %(default)s)")


def _addEngine(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("engine")
    group.add_argument("--resume", action="store_true",
                       help="go on with the last run: pairs that are done are skipped, those that are new or were left are done")
    where = group.add_mutually_exclusive_group()
    where.add_argument("--threads", type=_count, default=0, metavar="N", help="of this process (default 0: one for each core)")
    where.add_argument("--workers", type=_count, default=0, metavar="N", help="processes of a cluster on this machine (Dask)")
    where.add_argument("--scheduler", default="", metavar="tcp://HOST:PORT", help="of a cluster that runs already (Dask)")
    group.add_argument("--chunk", type=_count, default=CHUNK, metavar="N",
                       help="pairs that are handed out and stored together (default %(default)s)")
    bar = group.add_mutually_exclusive_group()
    bar.add_argument("--progress", action="store_true", default=None, help="a progress bar, whatever stderr is")
    bar.add_argument("--no-progress", action="store_false", dest="progress", help="no progress bar")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="usacv20-collection", epilog=_EPILOG,
                                     description="Two-view geometry of all pairs of a collection of images.")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)

    verify = commands.add_parser("verify", epilog=_EPILOG, help="all pairs of a COLMAP database",
                                 description="Estimates the two-view geometry of all pairs of a COLMAP database and writes "
                                 "its table two_view_geometries, from which colmap mapper goes on. Other tables of COLMAP are "
                                 "not changed.")
    verify.add_argument("database", metavar="DATABASE")
    verify.add_argument("--pairs", metavar="FILE",
                        help="verify only these pairs, the names of two images on a line; rows of others stay as they are")
    verify.add_argument("--output", metavar="COPY", help="leave the database as it is and write to a copy")
    scores = verify.add_mutually_exclusive_group()
    scores.add_argument("--scores", metavar="FILE", help="of the matches, as hloc writes them (HDF5)")
    scores.add_argument("--scores-column", metavar="NAME", help="of the table matches, with a float32 or float64 for each match")
    verify.add_argument("--lower-is-better", action="store_true", help="of the numbers in --scores-column (default: higher)")
    verify.add_argument("--no-loops", action="store_false", dest="loops",
                        help="keep pairs, too, whose rotation contradicts that of pairs with more matches (repeated structure)")
    _addEstimation(verify)
    _addEngine(verify)
    verify.set_defaults(function=_verify)

    pairs = commands.add_parser("pairs", epilog=_EPILOG, help="all pairs of a folder or file of matches",
                                description="The same for matches outside of a database: a folder of .corr or NPZ files, an "
                                "NPZ or HDF5 file of many pairs.")
    pairs.add_argument("list", metavar="LIST")
    pairs.add_argument("--output", metavar="FILE", required=True, help="results; its ending, .db, .npz or .h5, tells the format")
    pairs.add_argument("--keypoints", metavar="FILE", help="of hloc (HDF5), if LIST is its file of matches")
    _addEstimation(pairs)
    _addEngine(pairs)
    pairs.set_defaults(function=_pairs)

    report = commands.add_parser("report", help="what a run has found",
                                 description="Which pairs are verified and why the others are refused; inlier ratios, "
                                 "iterations, times; the pairs most worth a look.")
    report.add_argument("database", metavar="DATABASE", help="a database after verify, or the results of pairs")
    report.add_argument("--pictures", metavar="FOLDER",
                        help="write the histograms and the matrix of the pairs as PNG (matplotlib)")
    report.add_argument("--json", metavar="FILE", help="write the numbers of the report")
    report.add_argument("--csv", metavar="FILE", help="write a line for each pair")
    report.add_argument("--most", type=_count, default=5, metavar="N", help="pairs of a kind worth a look (default %(default)s)")
    report.set_defaults(function=_report)
    return parser


def _settings(options: argparse.Namespace) -> Dict[str, Any]:
    """Returns the settings that the arguments of the command specify, without the threshold."""
    return dict(method=options.method, confidence=options.confidence, maxIterations=options.max_iterations,
                inlierRatio=options.min_inlier_ratio, minInliers=options.min_inliers, significance=options.significance,
                watermarks=not options.no_watermarks, seed=options.seed)


def _engine(options: argparse.Namespace) -> Dict[str, Any]:
    if options.chunk < 1:
        raise CollectionError("chunk: a positive number is expected")
    return dict(threads=options.threads, chunk=options.chunk, workers=options.workers, scheduler=options.scheduler,
                progress=options.progress)


def _exitCode(summary: Summary) -> int:
    return INTERRUPTED if summary.interrupted else FAULTS if summary.faults else DONE


def _verify(options: argparse.Namespace) -> int:
    scores: Any = None
    if options.scores:
        scores = HlocScores(options.scores)
    elif options.scores_column:
        scores = ColumnScores(options.scores_column, not options.lower_is_better)
    return _exitCode(verifyDatabase(options.database, options.output, options.threshold, options.pairs, options.resume, scores,
                                    options.loops, _settings(options), say, **_engine(options)))


def _pairs(options: argparse.Namespace) -> int:
    from ._list_results import checkExtension, openResults, storedSettings
    from ._lists import ListSource
    checkExtension(options.output)
    engine = _engine(options)
    with contextlib.closing(ListSource(options.list, options.keypoints)) as source:
        stored = storedSettings(options.output) if options.resume else None
        settings = settle(source, options.threshold, _settings(options), stored, say)
        sink = openResults(options.output, source, settings.asDict(), options.resume)
        return _exitCode(go(source, sink, settings, say, **engine))


def _report(options: argparse.Namespace) -> int:
    from ._report import report
    return report(options.database, options.pictures, options.json, options.csv, options.most)


def main(arguments: Optional[typing.Sequence[str]] = None) -> int:
    """Runs a command and returns its exit code."""
    try:
        options = _parser().parse_args(arguments)
        result: int = options.function(options)
        return result
    except CollectionError as mistake:
        print("usacv20-collection: {}".format(mistake), file=sys.stderr)
        return MISTAKE
    except KeyboardInterrupt:
        return INTERRUPTED
