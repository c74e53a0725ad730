#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes the files of doc/measurements and the figures that README.md and doc/ quote from them.

    measure.py --build=BUILD --data=DATA [NAME ...]
                runs measurements (default: `lists`, which README.md quotes)
    measure.py --logs=USAC_BUILD_DIR
                takes counts of tests, coverage and times from the logs of run_tests.sh and sanitize.sh
    measure.py --build=BUILD --structured [SECTION ...]
                runs the commands above the tables of structured_tables.md, in all sections or in
                those whose headings begin with SECTION, and replaces the tables
    measure.py --fill
                writes all quotations again from the files of the measurements
    measure.py --copied NAME
                renews the date and the digest of constants_tables, structured_tables or
                collections_tables, after the output of a command has been copied there by hand
    measure.py --check
                fails if a quotation differs from the measurement, if a file was changed by hand,
                or if `lists` is older than the last change of results

BUILD is a build folder of this project; it is brought up to date first.
DATA is a folder of data as for usac_benchmark --data."""

import argparse
import collections
import contextlib
import datetime
import glob
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import figure_tables as tables
import gate_logs
import structured_tables
import threshold
from figures import FOLDER, HASHES, FiguresError, Measurement, Project, Rows, block, inline_block, read_text

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", ".."))
TWO_VIEWS = ("graf", "aloe", "office12_F", "office01_E")  # the sets of hashes.txt for H, F and E
OWN = ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_MAGSAC", "USACV20+scores")
OWN_ROWS = ("usacV20", "fast", "accurate", "magsacPlusPlus", "scores")
RIVALS = ("cv:USAC_DEFAULT", "cv:USAC_FAST", "cv:USAC_ACCURATE", "cv:USAC_MAGSAC")
FAST = "cv:USAC_FAST"
AUTO = "USACV20_AUTO"
THRESHOLD_PICTURE = "modules/usac/tutorials/threshold/images/threshold.png"
NAMES = {"USACV20+scores": "`USACV20` with match scores", AUTO: "`USACV20_AUTO`, given 3 times the threshold"}
NAMES.update({"cv:" + flag: "`cv::%s`" % flag for flag in ("RANSAC", "USAC_DEFAULT", "USAC_FAST", "USAC_ACCURATE", "USAC_MAGSAC")})
PRESETS = tuple("preset:" + p for p in ("usacV20", "fast", "accurate", "ransac", "msac", "lmeds", "mlesac", "prosac+scores", "loRansac",
                                        "floRansac", "gcRansac", "usac2013+scores", "paper", "magsac", "magsacPlusPlus"))
PICTURES = ("summary", "accuracy_over_time", "EVD_tent.H", "strecha.F", "strecha.E", "synth_general.E")


def processor_times():
    """Returns (busy seconds of all processors, processor seconds of this process and its ended
    children), or None if the system does not provide them."""
    try:
        numbers = [int(n) for n in read_text("/proc/stat").splitlines()[0].split()[1:9]]
    except (OSError, ValueError):
        return None
    return (sum(numbers) - numbers[3] - numbers[4]) / os.sysconf("SC_CLK_TCK"), sum(os.times()[:4])


def machine_name():
    model = re.search(r"^(?:model name|Model)\s*: (.*)$", read_text("/proc/cpuinfo"), re.M) if os.path.exists("/proc/cpuinfo") else None
    cores = os.cpu_count()
    return "%s, %d core%s" % (model.group(1).strip() if model else os.uname().machine, cores, "" if cores == 1 else "s")


def busy_words(before, after, seconds):
    """Returns a remark on other programs, if they took more than half of the processors during the
    `seconds` of a measurement; otherwise an empty text. `before` and `after` are results of
    processor_times()."""
    if not before or not after or seconds <= 0:
        return ""
    others = (after[0] - before[0] - (after[1] - before[1])) / seconds
    return "; other programs took %.1f of them" % others if others > 0.5 * os.cpu_count() else ""


def git(*arguments):
    done = subprocess.run(("git", "-C", ROOT) + arguments, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, universal_newlines=True)
    return done.stdout.strip() if done.returncode == 0 else ""


class Run:
    """The environment of a measurement: programs, data and a scratch folder. The object also records
    the commands and the number of repeats for the stamp."""

    def __init__(self, build, data, repeats, scratch):
        self.build, self.data, self.scratch, self.chosen = build, data, scratch, repeats
        self.repeats, self.commands = None, []
        self.opencv = self.find_opencv()

    def find_opencv(self):
        """Returns the version of OpenCV that the programs were built with: that of an installed
        OpenCV, or that of the build itself if the build folder is OpenCV's."""
        cache = read_text(os.path.join(self.build, "CMakeCache.txt"))
        folder = re.search(r"^OpenCV_DIR:\w+=(.*)$", cache, re.M)
        for path in [folder.group(1)] if folder else [self.build]:
            file = os.path.join(path, "OpenCVConfig-version.cmake")
            if os.path.isfile(file):
                return re.search(r"OpenCV_VERSION (\S+?)\)", read_text(file)).group(1)
        raise FiguresError("%s: no OpenCV was found in it" % self.build)

    def path(self, name):
        return os.path.join(self.scratch, name)

    def times(self, default):
        """Sets the number of repeats, to `default` if the user has chosen none; returns the option
        --repeats with this number."""
        self.repeats = self.chosen or default
        return "--repeats=%d" % self.repeats

    def call(self, program, *arguments, shown=True):
        """Runs a program; returns its standard output. If `shown`, the stamp gets the command, without
        options that name output files or programs, and with the words DATA and SCENES instead of the
        folders of data and scenes."""
        words = [program if program.endswith(".py") else os.path.join(self.build, "bin", program)] + list(arguments)
        if program.endswith(".py"):
            words = [sys.executable, os.path.join(ROOT, "modules", "usac", "benchmark", program)] + list(arguments)
        if shown:
            kept = [a for a in arguments if not re.match(r"--(csv|boundCsv|runs|program)=", a)]
            line = " ".join([program] + [shlex.quote(a) for a in kept])
            for folder, word in ((self.scratch, "SCENES"), (self.data, "DATA")):
                line = line.replace(folder, word) if folder else line
            if line not in self.commands:
                self.commands.append(line)
        print("-- " + " ".join(words), file=sys.stderr, flush=True)
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        done = subprocess.run(words, stdout=subprocess.PIPE, universal_newlines=True, env=environment)
        if done.returncode != 0:
            raise FiguresError("%s: exit code %d" % (program, done.returncode))
        return done.stdout

    def lists(self, letters):
        return sorted(path for letter in letters for path in glob.glob(os.path.join(self.data, "lists", "*.%s.list" % letter)))

    def benchmark(self, name, *options):
        """Runs usac_benchmark. Returns its tables, the path of the file with the individual runs, and its
        standard output without the title and with headings one level deeper."""
        csv, runs = self.path(name + ".csv"), self.path(name + ".runs.csv")
        text = self.call("usac_benchmark", *options, "--csv=" + csv, "--runs=" + runs)
        return tables.read_tables(csv), runs, re.sub("^#", "##", re.sub(r"\A# .*\n+", "", text), flags=re.M)

    def two_views(self, methods, *options):
        """Runs usac_benchmark once for each of H, F and E, on all lists. AUTO gets 3 times the
        threshold of the other methods."""
        found, runs, text = collections.OrderedDict(), [], ""
        for p in "HFE":
            named = ["%s{threshold=%g}" % (m, 3 * threshold.RIGHT[p]) if m == AUTO else m for m in methods]
            rows, file, more = self.benchmark(p, "--data=" + self.data, "--problem=" + p, "--methods=" + ",".join(named), *options)
            for key, table in rows.items():
                found[key] = collections.OrderedDict((m, table[name]) for m, name in zip(methods, named) if name in table)
            runs.append(file)
            text += "\n## All tables: %s\n\n%s" % (p, more)
        return found, runs, text

    def scenes(self, scene, name, *options):
        self.call("usac_synthetic", "--out=" + self.scratch, "--scene=" + scene, "--name=" + name, *options)


def pair_by_pair(files):
    import compare
    out = io.StringIO()
    compare.print_table(compare.read_pairs(files), "USACV20", list(RIVALS), out)
    return "\n#" + out.getvalue()


def measure_lists(run, more=("cv:RANSAC",)):
    methods = OWN + (AUTO, "USACV20_ACCURATE+scores") + more + ("cv:RHO",) + RIVALS + ("cv:USAC_PROSAC+scores",)
    found, files, text = run.two_views(methods, run.times(5), "--baseline=" + FAST)
    name, counts = run.name, [sum(t["USACV20"]["pairs"] for t in found.values()), len(found)]
    shown = [m for m in OWN + (AUTO,) + more + RIVALS]
    caption = tables.CAPTION.format(auc=" / for E the AUC of the pose error at 10 degrees")
    body = block(name + "/setting", "%d problems in %d lists, %d repeats" % (counts[0], counts[1], run.repeats))
    body += "\n## Averages\n\n%s\n\n" % caption
    body += block(name + "/averages", tables.averages(found, shown, NAMES))
    body += "\nThe other methods of the same run:\n\n" + tables.averages(found, [m for m in methods if m not in shown] + [FAST], None, FAST, ("cv:RHO",))
    body += "\n\nTime over all lists, geometric mean of the ratios of the medians:\n\n"
    body += block(name + "/times", tables.markdown(["to `%s`" % FAST] + ["`%s`" % m for m in OWN], [["all lists"] + [
        "%.2f" % tables.geometric_mean([t[m]["median_cpu_ms"] / t[FAST]["median_cpu_ms"] for t in found.values()]) for m in OWN]]))
    body += "\n## List by list\n\nMedian error / failures in % / CPU ms / for E AUC at 10 degrees.\n\n"
    body += tables.single_lists(found, OWN + (FAST, "cv:USAC_ACCURATE"), RIVALS)
    body += ("\n\n## Where `USACV20` is behind\n\nAll lists on which its median error is more than 2 %% above the best of four flags, it fails more often, or takes "
             "2 %% longer than `%s` (bold).\n\n" % FAST) + block(name + "/losses", tables.losses(found, "USACV20", RIVALS, FAST))
    if name == "lists":
        run.call("plot.py", *files, "--out=" + run.scratch, shown=False)
        for picture in PICTURES:
            shutil.copy(run.path(picture + ".png"), os.path.join(ROOT, FOLDER, picture + ".png"))
    return body + pair_by_pair(files) + text


def measure_lists_4_10(run):
    if not run.opencv.startswith("4.10."):
        raise FiguresError("lists_4.10 needs a build with OpenCV 4.10, not %s" % run.opencv)
    return measure_lists(run, ())


def measure_presets(run):
    found, _, text = run.two_views(PRESETS, run.times(1), "--baseline=" + PRESETS[0])
    names = {m: "`%s`" % m.replace("preset:", "") for m in PRESETS}
    caption = tables.CAPTION.format(auc=" / for E the AUC of the pose error at 10 degrees")
    return "%s. `+scores`: points in the order of their scores. No list is left out for `lmeds`, which needs half of the matches to be right.\n\n%s%s" % (
        caption, block("presets/averages", tables.averages(found, PRESETS, names, hopeless=("preset:lmeds",))), text)


def measure_threshold(run):
    run.times(3)
    text = run.call("threshold.py", "--program=" + os.path.join(run.build, "bin", "usac_benchmark"), "--repeats=%d" % run.repeats,
                    *["--list=" + path for path in run.lists("HFE")])
    run.commands = ["threshold.py --data=DATA --repeats=%d (lists of H, F and E)" % run.repeats]
    text = re.sub(r"\A# .*\n+", "", text)
    head, _, last = text.rpartition("\n| threshold |")
    return head + "\n" + block("threshold/ratios", "| threshold |" + last)


def measure_automatic(run):
    """Compares USACV20_AUTO, which estimates the threshold, with several given thresholds."""
    text = run.call("threshold.py", "--program=" + os.path.join(run.build, "bin", "usac_benchmark"), run.times(3), "--estimated=" + AUTO,
                    "--plot=" + os.path.join(ROOT, THRESHOLD_PICTURE), *["--list=" + path for path in run.lists("HFE")])
    run.commands = ["threshold.py --data=DATA --repeats=%d --estimated=USACV20_AUTO (lists of H, F and E)" % run.repeats]
    return ("Right thresholds: H 2 px, F and E 1 px. Given thresholds: `USACV20`. Errors: ratio of the median error to the "
            "smallest median error with a given threshold. CPU: ratio of the mean CPU time to that with the right threshold. "
            "Both are geometric means over lists; failures and AUC are means over lists.\n" +
            block("automatic/table", text.strip()))


def measure_pose(run):
    methods = ("USACV20", "USACV20_FAST", "USACV20+scores", "USACV20_MAGSAC", FAST, "cv:USAC_MAGSAC", "cv:PNP_P3P", "cv:PNP_ITERATIVE",
               "cv:PNP_EPNP")
    found, _, _ = run.benchmark("pose", *["--list=" + path for path in run.lists("P")], run.times(7), "--baseline=" + FAST,
                                "--methods=" + ",".join(methods))
    return "\n".join("%d views. Error: angle between the rotations in degrees, median; center error: percent of the depth of "
                     "the scene, median.\n\n%s" % (
        table["USACV20"]["pairs"], block("pose/" + name, tables.ratios(table, methods, FAST))) for (_, name), table in found.items())


def measure_affine(run):
    body = ("1000 matches, noise of half a pixel, uniform wrong matches, 20 pairs per list. Median error in pixels / failures in "
            "%; CPU time: median.\n")
    for letter, scene, flag in (("A", "affinity", "cv:RANSAC"), ("S", "similarity", "cv:RANSAC")):
        for part in ("0.5", "0.2"):
            run.scenes(scene, "%s_%s" % (scene, part), "--inliers=" + part, "--pairs=20")
        found, _, _ = run.benchmark(letter, "--data=" + run.scratch, "--problem=" + letter, run.times(3), "--baseline=" + flag,
                                    "--methods=USACV20,USACV20_FAST," + flag)
        body += "\n" + block("affine/" + scene, tables.against(found, ["USACV20", "USACV20_FAST"], flag))
    return body


def measure_rigid(run):
    body = ("Noise of half a unit; the cloud of points is 200 units wide; uniform wrong matches, 20 pairs per list. The names "
            "of lists have the number of matches and the fraction of right ones. Error: angle between the rotations in degrees, "
            "median / failures in %; CPU time: median.\n")
    for letter, scene in (("R", "rigid"), ("M", "rigidScaled")):
        for size in (200, 1000, 10000):
            for part in ("0.1", "0.2", "0.5", "0.8"):
                run.scenes(scene, "%s_%d_%s" % (scene, size, part), "--inliers=" + part, "--size=%d" % size, "--pairs=20")
        found, _, _ = run.benchmark(letter, "--data=" + run.scratch, "--problem=" + letter, run.times(3), "--baseline=cv:AFFINE3D",
                                    "--methods=USACV20,USACV20_FAST,cv:AFFINE3D,cv:AFFINE3D_REFIT")
        body += "\n" + block("rigid/" + scene, tables.against(found, ["USACV20", "USACV20_FAST", "cv:AFFINE3D_REFIT"], "cv:AFFINE3D"))
    return body


def measure_tracking(run):
    run.repeats = run.chosen or 5
    run.call("usac_tracking", "--sequences=%d" % run.repeats, "--csv=" + run.path("tracking.csv"))
    return ("Median error (P degrees, H pixels) / failures in % of the frames / samples per frame / ratio of the CPU time to "
            "that with the default limit without a model / failed frames after the jump until the first success.\n\n" +
            block("tracking/table", tables.tracking(run.path("tracking.csv"))))


def measure_scale(run):
    text = run.call("usac_scale", run.times(5), "--limit=1500", "--csv=" + run.path("scale.csv"))
    run.call("plot_scale.py", run.path("scale.csv"), "--out=" + run.scratch, shown=False)
    for picture in ("scale_time", "scale_error"):
        shutil.copy(run.path(picture + ".png"), os.path.join(ROOT, FOLDER, picture + ".png"))
    before, _, bound = re.sub(r"\A# .*\n+", "", text).partition("\n| problem |")
    return before + "\n" + block("scale/bound", "| problem |" + bound)


def measure_phases(run):
    run.repeats = 1
    text = run.call("phases.py", "--build=" + run.build)
    run.commands = ["phases.py --build=BUILD"]
    return ("`USACV20` on synthetic scenes, ten of each kind: instructions of a call, and the percentage of them in each phase. "
            "Samples: drawing their points, with the ordering of the points; graph cut: with the neighborhoods of the points; "
            "rest: reading, normalization, runners-up, termination, mask.\n\n" +
            block("phases/table", text.strip()))


def measure_threads(run):
    found, _, _ = run.two_views(("USACV20", "USACV20_PARALLEL"), run.times(3), "--threads=2", "--baseline=USACV20")
    rows = [["%s %s" % key, "%.2f" % (t["USACV20"]["mean_wall_ms"] / t["USACV20_PARALLEL"]["mean_wall_ms"])] for key, t in found.items()]
    return ("Mean wall time of `USACV20`, divided by that of `USACV20_PARALLEL`; meaningless if other programs use the "
            "processors.\n\n" + block("threads/table", tables.markdown(["list", "times faster"], rows, True)))


def measure_covariance(run):
    """Measures how well Report::covariance describes the errors on synthetic scenes."""
    run.repeats = 1
    text = run.call("usac_covariance", "--scenes=%d" % (run.chosen or 10000))
    return ("Scenes of each problem, the same number for each combination of shape, number of matches (20 to 1000), fraction of "
            "right matches (10 to 95 %; F, E: 30 to 95 %) and noise (standard deviation of each component of 0.1, 0.3 and 1 "
            "thresholds). Wrong: models with a root mean square error of more than a threshold on the noise-free right matches. "
            "For the other models, mean / d: mean squared Mahalanobis distance of the true model, divided by the number of "
            "parameters, aim 0.9 to 1.1; within 95 %: percentage of the true models in the 95 % confidence region, aim 93 to "
            "97 %; noise: mean ratio of `Report::sigma` to the true noise. planeN: N percent of the right matches are on a "
            "plane.\n\n" +
            block("covariance/table", text.strip()))


def measure_sigmas(run):
    """Measures how much Params::sigmas reduces the errors of models if every second match has five
    times the noise of the other matches, or each point five times the noise in one direction."""
    run.repeats = 1
    options = ["--spread=5", "--noises=0.1,0.3", "--scenes=%d" % (run.chosen or 2000)]
    text = run.call("usac_covariance", "--by=problem,ratio", *options)
    directed = run.call("usac_covariance", "--directed=1", "--problems=H,F,E,A,S,P", "--by=problem", *options)
    return ("Scenes as in [covariance.md](covariance.md), with noise of 0.1 and 0.3 thresholds; every second match has five "
            "times this noise, and the estimator gets these ratios as `Params::sigmas`. Error: geometric mean of the ratio of "
            "the error to that of least squares over the right matches with weights from their true noise, aim 1.1; without "
            "sigmas: the same for an estimator that gets no sigmas, but five times the threshold.\n\n" +
            block("sigmas/table", text.strip()) +
            "\n\nThe same if each point of an image has five times this noise in a random direction, and the estimator gets the "
            "covariances of the points.\n\n" + block("sigmas/directed", directed.strip()))


Kind = collections.namedtuple("Kind", "title measure rows current")
TWO_VIEW_ROWS = Rows(TWO_VIEWS, OWN_ROWS)
KINDS = collections.OrderedDict((
    ("lists", Kind("H, F and E on public lists and synthetic scenes", measure_lists, TWO_VIEW_ROWS, True)),
    ("lists_4.10", Kind("H, F and E on the same lists, OpenCV 4.10", measure_lists_4_10, TWO_VIEW_ROWS, False)),
    ("presets", Kind("The presets of the literature", measure_presets, Rows(TWO_VIEWS), False)),
    ("threshold", Kind("Sensitivity to the threshold", measure_threshold, Rows(TWO_VIEWS, ("usacV20", "magsacPlusPlus")), False)),
    ("automatic", Kind("The estimated threshold", measure_automatic, Rows(TWO_VIEWS, ("usacV20", "automatic")), False)),
    ("pose", Kind("Absolute pose", measure_pose, Rows(("absolutePose", "absolutePose_lens"), OWN_ROWS), False)),
    ("affine", Kind("Affinities and similarities", measure_affine, Rows(("affinity", "similarity"), ("usacV20", "fast")), False)),
    ("rigid", Kind("Rigid motions of space", measure_rigid, Rows(("rigid3D", "similarity3D"), ("usacV20", "fast")), False)),
    ("tracking", Kind("A model for the next frame", measure_tracking, Rows(("graf", "absolutePose"), ("usacV20",)), False)),
    ("scale", Kind("Time over size and hardness; the search and its lower bound", measure_scale, Rows(TWO_VIEWS, ("usacV20", "fast")), False)),
    ("covariance", Kind("How sure: the calibration of the covariance", measure_covariance, Rows(), False)),
    ("sigmas", Kind("The noise of each match", measure_sigmas, Rows(), False)),
    ("phases", Kind("The time of a call, phase by phase", measure_phases, Rows(TWO_VIEWS, ("usacV20",)), False)),
    ("threads", Kind("Two threads", measure_threads, Rows(TWO_VIEWS, ("usacV20", "parallel")), False)),
    ("tests", Kind("Tests, sanitizers, fuzzer, coverage", None, Rows(), False)),
    ("constants_tables", Kind("Half and double of the chosen numbers; choices between variants", None, Rows(), False)),
    ("structured_tables", Kind("Structured scenes", None, Rows(), False)),
    ("collections_tables", Kind("Collections of images", None, Rows(), False))))
COPIED = tuple(name for name in KINDS if name.endswith("_tables"))  # files with tables and the commands that print these tables
PROGRAMS = ("usac_benchmark", "usac_covariance", "usac_scale", "usac_structured", "usac_synthetic", "usac_tracking")


def project():
    return Project(ROOT, {name: kind.rows for name, kind in KINDS.items()}, [name for name, kind in KINDS.items() if kind.current])


def state():
    """Returns the commit of the sources, with a remark if C++ files in the working tree differ from
    this commit."""
    changed = git("status", "--porcelain", "--", "modules/usac/src", "modules/usac/include", "modules/usac/benchmark")
    return (git("rev-parse", "--short", "HEAD") or "-") + (" and changes" if re.search(r"\.[ch]pp$", changed, re.M) else "")


def today():
    return "%s" % datetime.datetime.now(datetime.timezone.utc).date()


def stamp_line(stamp):
    """Returns the stamp as one line, for a document."""
    return "%s, commit %s, OpenCV %s, %s" % (stamp["date"], stamp["commit"], stamp["OpenCV"], stamp["machine"])


def measure(name, build, data, repeats):
    kind = KINDS[name]
    with tempfile.TemporaryDirectory() as scratch:
        run = Run(build, data, repeats, scratch)
        run.name = name
        clock, before = datetime.datetime.now(), processor_times()
        body = kind.measure(run)
        words = busy_words(before, processor_times(), (datetime.datetime.now() - clock).total_seconds())
        stamp = {"command": "`%s`" % "; ".join(run.commands), "commit": state(), "date": today(), "machine": machine_name() + words,
                 "OpenCV": run.opencv, "repeats": str(run.repeats), "results": kind.rows.digest(read_text(os.path.join(ROOT, HASHES)))}
        body = "%s\n\n%s" % (inline_block(name + "/stamp", stamp_line(stamp)), body)
        Measurement(name, kind.title, stamp, body).write(ROOT)


def tested(time, commit):
    """Returns (commit, digest of hashes.txt) of the state that was tested when a log was written. If
    `commit` is empty, the last commit before `time` is used."""
    commit = commit or git("log", "-1", "--format=%h", "--before=" + time.isoformat())
    return commit or "-", KINDS["tests"].rows.digest(git("show", "%s:%s" % (commit, HASHES)) or read_text(os.path.join(ROOT, HASHES)))


def take_logs(folder):
    """Writes doc/measurements/tests.md; returns the names of the parts that have a log."""
    path = Measurement.file(ROOT, "tests")
    rows = gate_logs.parse_table(read_text(path)) if os.path.isfile(path) else {}
    found = {name: gate_logs.read_row(folder, name, tested) for name in gate_logs.PARTS}
    found = {name: row for name, row in found.items() if row}
    if not found:
        raise FiguresError("%s: no log of run_tests.sh or sanitize.sh" % folder)
    rows.update(found)
    write_tests(rows)
    return list(found)


def write_tests(rows):
    digest = KINDS["tests"].rows.digest(read_text(os.path.join(ROOT, HASHES)))
    stamp = {"command": "`run_tests.sh`, `sanitize.sh`", "commit": "of each part", "date": max(row["date"] for row in rows.values()), "machine": machine_name(),
             "OpenCV": "of each part", "repeats": "1", "results": next((r["results"] for r in rows.values() if r["results"] != digest), digest)}
    body = "Each part as it was run last, with the OpenCV that `run_tests.sh` names for it.\n\n%s\n\nIn README.md:\n\n" % gate_logs.table(rows)
    body += "\n".join("- %s: %s" % (name, inline_block("tests/" + name, text)) for name, text in gate_logs.sentences(rows).items())
    Measurement("tests", KINDS["tests"].title, stamp, body).write(ROOT)


def take_copied(root, name):
    """Sets the date of a file with copied tables to today and renews the digest of its text. `results`
    in the stamp stays, because it belongs to the oldest table of the file."""
    if name not in COPIED:
        raise FiguresError("%s is none of %s" % (name, ", ".join(COPIED)))
    m = Measurement.read(root, name)
    m.stamp["date"] = today()
    m.write(root)


def measure_structured(build, sections):
    """Runs the commands in these sections of structured_tables.md, or in all sections if the list is
    empty, and replaces the tables. `results` in the stamp stays, because it belongs to the oldest table
    of the file."""
    m = Measurement.read(ROOT, "structured_tables")
    run = Run(build, "", None, "")
    m.body = structured_tables.renewed(m.body, sections, state(), lambda arguments: run.call(structured_tables.PROGRAM, *arguments))
    m.stamp.update({"date": today(), "OpenCV": run.opencv})
    m.write(ROOT)


def check(out):
    """Prints all mistakes in the figures of documents; returns the number of mistakes."""
    state_of_all = project()
    mistakes = state_of_all.check()
    for mistake in mistakes:
        print(mistake, file=out)
    older = [] if state_of_all.mistakes else [name for name in state_of_all.older() if not KINDS[name].current]
    if older:
        print("measurements of older results: %s" % ", ".join(older), file=sys.stderr)
    return len(mistakes)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(name for name, kind in KINDS.items() if kind.measure))
    parser.add_argument("--build", metavar="DIR")
    parser.add_argument("--data", metavar="DIR", help="not needed by affine, rigid, tracking, scale, covariance, sigmas and phases")
    parser.add_argument("--repeats", type=int, help="number of repeats, instead of the default of each measurement")
    parser.add_argument("--logs", metavar="DIR", help="folder with the logs of run_tests.sh and sanitize.sh")
    parser.add_argument("--copied", metavar="NAME", help=", ".join(COPIED))
    parser.add_argument("--structured", nargs="*", metavar="SECTION")
    parser.add_argument("--fill", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args(arguments)
    try:
        if options.check:
            return 1 if check(sys.stdout) else 0
        names = options.names or ([name for name, kind in KINDS.items() if kind.current] if options.build and options.structured is None else [])
        unknown = [name for name in names if name not in KINDS or not KINDS[name].measure]
        if unknown:
            raise FiguresError("no measurement %s" % ", ".join(unknown))
        if (names or options.structured is not None) and not options.build:
            raise FiguresError("--build is missing")
        if not names and options.structured is None and not options.logs and not options.fill and not options.copied:
            parser.error("nothing to do")
        if names or options.structured is not None:
            subprocess.run(["cmake", "--build", options.build, "--target"] + list(PROGRAMS), check=True, stdout=sys.stderr)
        if options.structured is not None:
            measure_structured(options.build, options.structured)
        for name in names:
            measure(name, options.build, options.data, options.repeats)
        if options.logs:
            print("logs: %s" % ", ".join(take_logs(options.logs)))
        if options.copied:
            take_copied(ROOT, options.copied)
        for document in project().fill():
            print("written: " + document)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
