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

from .._start import listen
from ._engine import CHUNK, Summary, checkNumbers
from ._output import say
from ._pair import CollectionError
from ._scores import ColumnScores, HlocScores
from ._settings import METHODS, Settings
from ._verify import go, settle, verifyDatabase

DONE, FAULTS, MISTAKE, INTERRUPTED = 0, 1, 2, 130

_EPILOG = """exit code: 0 all pairs are done (refused pairs, too); 1 some pairs cannot be read, and the first of them are named on
stderr; 2 the command could not start or continue, and a message says why; 130 interrupted: the results so far are stored, and
--resume continues the run"""


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
        raise argparse.ArgumentTypeError("an integer of at least 0 is expected, not {!r}".format(text))
    return number


def _addEstimation(parser: argparse.ArgumentParser) -> None:
    default = Settings()
    group = parser.add_argument_group("estimation")
    group.add_argument("--threshold", type=_threshold, default=None, metavar="PIXELS",
                       help="maximum error of an inlier, or auto (default): estimated from a sample of the pairs or, with "
                            "--resume, equal to the threshold of the last run; with --method USACV20_AUTO, upper limit of the "
                            "threshold that is estimated for each pair")
    group.add_argument("--method", choices=sorted(METHODS), default=default.method,
                       help="method flag of usacv20 (default %(default)s)")
    group.add_argument("--confidence", type=float, default=default.confidence,
                       help="probability that the model of a pair is found, see --min-inlier-ratio (default %(default)s)")
    group.add_argument("--max-iterations", type=_count, default=default.maxIterations, metavar="N",
                       help="maximum number of samples for a model (default %(default)s); if it is too small for --confidence, "
                            "the reason of a refused pair says so")
    group.add_argument("--min-inlier-ratio", type=float, default=default.inlierRatio, metavar="PART",
                       help="smallest inlier ratio for which the model is found with probability --confidence; determines the "
                            "number of samples (default %(default)s)")
    group.add_argument("--min-inliers", type=_count, default=default.minInliers, metavar="N",
                       help="minimum number of inliers of an accepted pair (default %(default)s)")
    group.add_argument("--significance", type=float, default=default.significance, metavar="CHANCE",
                       help="upper limit of the probability that random matches would give an equally good result: of pairs "
                            "without overlap whose matches are random, at most this fraction is accepted; of those whose wrong "
                            "matches agree with each other, as with repeated structure, it can be more (default %(default)s)")
    group.add_argument("--no-watermarks", action="store_true",
                       help="do not detect pairs that have only a mark or frame in common")
    group.add_argument("--seed", type=int, default=default.seed, help="seed of the pseudo-random samples (default %(default)s)")


def _addEngine(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("engine")
    group.add_argument("--resume", action="store_true",
                       help="continue the last run: pairs that are done are skipped; new pairs, pairs that were not done and, in "
                            "a database, pairs that another program has changed are processed")
    where = group.add_mutually_exclusive_group()
    where.add_argument("--threads", type=_count, default=0, metavar="N",
                       help="number of threads of this process (default 0: one for each core)")
    where.add_argument("--workers", type=_count, default=0, metavar="N",
                       help="number of worker processes to start on this machine (Dask)")
    where.add_argument("--scheduler", default="", metavar="tcp://HOST:PORT",
                       help="address of the scheduler of a running cluster (Dask)")
    group.add_argument("--chunk", type=_count, default=CHUNK, metavar="N",
                       help="number of pairs that are estimated and stored together (default %(default)s)")
    bar = group.add_mutually_exclusive_group()
    bar.add_argument("--progress", action="store_true", default=None, help="show a progress bar even if stderr is not a terminal")
    bar.add_argument("--no-progress", action="store_false", dest="progress", help="show no progress bar")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="usacv20-collection", epilog=_EPILOG,
                                     description="Estimates the two-view geometry of all pairs of a collection of images.")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)

    verify = commands.add_parser("verify", epilog=_EPILOG, help="estimate all pairs of a COLMAP database",
                                 description="Estimates the two-view geometry of all pairs of a COLMAP database and writes "
                                 "its table two_view_geometries, which colmap mapper reads. Other tables of COLMAP are not "
                                 "changed.")
    verify.add_argument("database", metavar="DATABASE")
    verify.add_argument("--pairs", metavar="FILE",
                        help="verify only the pairs in this file, with two image names on each line; rows of other pairs do not "
                             "change")
    verify.add_argument("--output", metavar="COPY", help="do not change the database, but write to a copy of it")
    scores = verify.add_mutually_exclusive_group()
    scores.add_argument("--scores", metavar="FILE", help="file with scores of the matches, as hloc writes it (HDF5)")
    scores.add_argument("--scores-column", metavar="NAME",
                        help="column of the table matches with a float32 or float64 score for each match")
    verify.add_argument("--lower-is-better", action="store_true",
                        help="lower scores in --scores-column are better (default: higher)")
    verify.add_argument("--no-loops", action="store_false", dest="loops",
                        help="also keep pairs whose rotation contradicts that of pairs with more inliers, as repeated structure "
                             "causes them")
    _addEstimation(verify)
    _addEngine(verify)
    verify.set_defaults(function=_verify)

    pairs = commands.add_parser("pairs", epilog=_EPILOG, help="estimate all pairs of a folder or file of matches",
                                description="Estimates the two-view geometry of all pairs whose matches are outside of a "
                                "database: in a folder of .corr, NPZ or HDF5 files, or in an NPZ or HDF5 file of many pairs.")
    pairs.add_argument("list", metavar="LIST")
    pairs.add_argument("--output", metavar="FILE", required=True,
                       help="file for the results; its extension, such as .db, .npz or .h5, determines the format")
    pairs.add_argument("--keypoints", metavar="FILE", help="hloc's file of features (HDF5), if LIST is hloc's file of matches")
    _addEstimation(pairs)
    _addEngine(pairs)
    pairs.set_defaults(function=_pairs)

    report = commands.add_parser("report", help="describe the results of a run",
                                 description="Shows how many pairs are verified and why the others are refused, inlier "
                                 "ratios, numbers of samples and times, and lists pairs that should be checked.")
    report.add_argument("database", metavar="DATABASE", help="a database after verify, or the results of pairs")
    report.add_argument("--pictures", metavar="FOLDER",
                        help="write the histograms and the matrix of the pairs to this folder as PNG files (needs matplotlib)")
    report.add_argument("--json", metavar="FILE", help="write the numbers of the report to this file")
    report.add_argument("--csv", metavar="FILE", help="write a line for each pair to this file")
    report.add_argument("--most", type=_count, default=5, metavar="N",
                        help="maximum number of listed pairs of each kind that should be checked (default %(default)s)")
    report.set_defaults(function=_report)
    return parser


def _settings(options: argparse.Namespace) -> Dict[str, Any]:
    """Returns the settings that the arguments of the command specify, without the threshold."""
    return dict(method=options.method, confidence=options.confidence, maxIterations=options.max_iterations,
                inlierRatio=options.min_inlier_ratio, minInliers=options.min_inliers, significance=options.significance,
                watermarks=not options.no_watermarks, seed=options.seed)


def _engine(options: argparse.Namespace) -> Dict[str, Any]:
    engine = dict(threads=options.threads, chunk=options.chunk, workers=options.workers, scheduler=options.scheduler,
                  progress=options.progress)
    checkNumbers(**engine)
    return engine


def _exitCode(summary: Summary) -> int:
    return INTERRUPTED if summary.interrupted else FAULTS if summary.faults else DONE


def _verify(options: argparse.Namespace) -> int:
    scores: Any = None
    if options.lower_is_better and not options.scores_column:
        raise CollectionError("--lower-is-better: goes with --scores-column only; higher scores in a file of hloc are better")
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
        listen()
        options = _parser().parse_args(arguments)
        result: int = options.function(options)
        return result
    except CollectionError as mistake:
        print("usacv20-collection: {}".format(mistake), file=sys.stderr)
        return MISTAKE
    except KeyboardInterrupt:
        return INTERRUPTED
