#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes the files of doc/measurements, with a stamp of commit, date, machine and OpenCV's version.

    measure.py --build=BUILD --data=DATA [NAME ...]
                runs measurements (default: `lists`, from which README.md has numbers)
    measure.py --build=BUILD structured_tables [--section=SECTION ...]
                runs the commands above the tables of structured_tables.md, in all sections or in
                those whose headings begin with a SECTION, and replaces the tables

BUILD is a build folder of this project; it is brought up to date first.
DATA is a folder of data as for usac_benchmark --data."""

import argparse
import collections
import datetime
import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import figure_tables as tables
import structured_tables
import threshold

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", ".."))
FOLDER = "doc/measurements"
STAMP = ("command", "commit", "date", "machine", "OpenCV", "repeats")
OWN = ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "USACV20_MAGSAC", "USACV20+scores")
SINGLE = ("USACV20", "USACV20_FAST", "USACV20_ACCURATE", "cv:USAC_FAST", "cv:USAC_ACCURATE")
RIVALS = ("cv:USAC_DEFAULT", "cv:USAC_FAST", "cv:USAC_ACCURATE", "cv:USAC_MAGSAC")
FAST = "cv:USAC_FAST"
AUTO = "USACV20_AUTO"
THRESHOLD_PICTURE = "modules/usac/tutorials/threshold/images/threshold.png"
NAMES = {"USACV20+scores": "`USACV20` with match scores", AUTO: "`USACV20_AUTO`, given 3 times the threshold"}
NAMES.update({"cv:" + flag: "`cv::%s`" % flag for flag in ("RANSAC", "USAC_DEFAULT", "USAC_FAST", "USAC_ACCURATE", "USAC_MAGSAC")})
PICTURES = ("summary", "accuracy_over_time", "EVD_tent.H", "strecha.F", "strecha.E", "synth_general.E")


class MeasureError(ValueError):
    pass


def read_text(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Measurement:
    """A file of doc/measurements. `stamp` is {key of STAMP: text}."""

    def __init__(self, name, title, stamp, body):
        self.name, self.title, self.stamp, self.body = name, title, stamp, body.strip() + "\n"

    @staticmethod
    def file(name):
        return os.path.join(ROOT, FOLDER, name + ".md")

    @classmethod
    def read(cls, name):
        text = read_text(cls.file(name))
        head = re.match(r"# (.*)\n\n\| measurement \| \S+ \|\n\|---\|---\|\n((?:\| [^|\n]+ \| [^|\n]+ \|\n)+)\n", text)
        if not head:
            raise MeasureError("%s/%s.md: no stamp" % (FOLDER, name))
        stamp = dict(line.strip("| ").split(" | ", 1) for line in head.group(2).splitlines())
        return cls(name, head.group(1), stamp, text[head.end():])

    def write(self):
        rows = "".join("| %s | %s |\n" % (key, self.stamp[key]) for key in STAMP)
        with open(self.file(self.name), "w", encoding="utf-8") as file:
            file.write("# %s\n\n| measurement | %s |\n|---|---|\n%s\n%s" % (self.title, self.name, rows, self.body))


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
        raise MeasureError("%s: no OpenCV was found in it" % self.build)

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
            kept = [a for a in arguments if not re.match(r"--(csv|runs|program)=", a)]
            line = " ".join([program] + [shlex.quote(a) for a in kept])
            for folder, word in ((self.scratch, "SCENES"), (self.data, "DATA")):
                line = line.replace(folder, word) if folder else line
            if line not in self.commands:
                self.commands.append(line)
        print("-- " + " ".join(words), file=sys.stderr, flush=True)
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        done = subprocess.run(words, stdout=subprocess.PIPE, universal_newlines=True, env=environment)
        if done.returncode != 0:
            raise MeasureError("%s: exit code %d" % (program, done.returncode))
        return done.stdout

    def lists(self, letters):
        return sorted(path for letter in letters for path in glob.glob(os.path.join(self.data, "lists", "*.%s.list" % letter)))

    def benchmark(self, name, *options):
        """Runs usac_benchmark; returns its tables and the path of the file with the individual runs."""
        csv, runs = self.path(name + ".csv"), self.path(name + ".runs.csv")
        self.call("usac_benchmark", *options, "--csv=" + csv, "--runs=" + runs)
        return tables.read_tables(csv), runs

    def two_views(self, methods, *options):
        """Runs usac_benchmark once for each of H, F and E, on all lists. AUTO gets 3 times the
        threshold of the other methods."""
        found, runs = collections.OrderedDict(), []
        for p in "HFE":
            named = ["%s{threshold=%g}" % (m, 3 * threshold.RIGHT[p]) if m == AUTO else m for m in methods]
            rows, file = self.benchmark(p, "--data=" + self.data, "--problem=" + p, "--methods=" + ",".join(named), *options)
            for key, table in rows.items():
                found[key] = collections.OrderedDict((m, table[name]) for m, name in zip(methods, named) if name in table)
            runs.append(file)
        return found, runs

    def scenes(self, scene, name, *options):
        self.call("usac_synthetic", "--out=" + self.scratch, "--scene=" + scene, "--name=" + name, *options)


def measure_lists(run):
    methods = OWN + (AUTO, "USACV20_ACCURATE+scores", "cv:RANSAC", "cv:RHO") + RIVALS + ("cv:USAC_PROSAC+scores",)
    found, files = run.two_views(methods, run.times(5))
    shown = [m for m in OWN + (AUTO, "cv:RANSAC") + RIVALS]
    body = "%d problems in %d lists, %d repeats.\n" % (sum(t["USACV20"]["pairs"] for t in found.values()), len(found), run.repeats)
    body += "\n## Averages\n\n%s\n\n" % tables.CAPTION + tables.averages(found, shown, NAMES)
    body += "\n\nThe other methods of the same run:\n\n" + tables.averages(found, [m for m in methods if m not in shown] + [FAST], None, FAST, ("cv:RHO",))
    body += "\n\nTime over all lists, geometric mean of the ratios of the medians:\n\n"
    body += tables.markdown(["to `%s`" % FAST] + ["`%s`" % m for m in OWN], [["all lists"] + [
        "%.2f" % tables.geometric_mean([t[m]["median_cpu_ms"] / t[FAST]["median_cpu_ms"] for t in found.values()]) for m in OWN]])
    body += "\n\n## List by list\n\nMedian error / failures in % / CPU ms / for E AUC at 10 degrees.\n\n"
    body += tables.single_lists(found, SINGLE, RIVALS)
    body += ("\n\n## Where `USACV20` is behind\n\nAll lists on which its median error is more than 2 %% above the best of four flags, it fails more often, or takes "
             "2 %% longer than `%s` (bold).\n\n" % FAST) + tables.losses(found, "USACV20", RIVALS, FAST)
    run.call("plot.py", *files, "--out=" + run.scratch, shown=False)
    for picture in PICTURES:
        shutil.copy(run.path(picture + ".png"), os.path.join(ROOT, FOLDER, picture + ".png"))
    return body


def measure_threshold(run):
    run.times(3)
    text = run.call("threshold.py", "--program=" + os.path.join(run.build, "bin", "usac_benchmark"), "--repeats=%d" % run.repeats,
                    *["--list=" + path for path in run.lists("HFE")])
    run.commands = ["threshold.py --data=DATA --repeats=%d (lists of H, F and E)" % run.repeats]
    return re.sub(r"\A# .*\n+", "", text)


def measure_automatic(run):
    """Compares USACV20_AUTO, which estimates the threshold, with several given thresholds."""
    text = run.call("threshold.py", "--program=" + os.path.join(run.build, "bin", "usac_benchmark"), run.times(3), "--estimated=" + AUTO,
                    "--plot=" + os.path.join(ROOT, THRESHOLD_PICTURE), *["--list=" + path for path in run.lists("HFE")])
    run.commands = ["threshold.py --data=DATA --repeats=%d --estimated=USACV20_AUTO (lists of H, F and E)" % run.repeats]
    return ("Right thresholds: H 2 px, F and E 1 px. Given thresholds: `USACV20`. Errors: ratio of the median error to the "
            "smallest median error with a given threshold. CPU: ratio of the mean CPU time to that with the right threshold. "
            "Both are geometric means over lists; failures and AUC are means over lists.\n\n" + text)


def measure_pose(run):
    methods = ("USACV20", "USACV20_FAST", "USACV20+scores", "USACV20_MAGSAC", FAST, "cv:USAC_MAGSAC", "cv:PNP_P3P", "cv:PNP_ITERATIVE",
               "cv:PNP_EPNP")
    found, _ = run.benchmark("pose", *["--list=" + path for path in run.lists("P")], run.times(7),
                                "--methods=" + ",".join(methods))
    return "\n".join("%d views. Error: angle between the rotations in degrees, median; center error: percent of the depth of "
                     "the scene, median.\n\n%s" % (
        table["USACV20"]["pairs"], tables.ratios(table, methods, FAST) + "\n") for table in found.values())


def measure_affine(run):
    body = ("1000 matches, noise of half a pixel, uniform wrong matches, 20 pairs per list. Median error in pixels / failures in "
            "%; CPU time: median.\n")
    for letter, scene, flag in (("A", "affinity", "cv:RANSAC"), ("S", "similarity", "cv:RANSAC")):
        for part in ("0.5", "0.2"):
            run.scenes(scene, "%s_%s" % (scene, part), "--inliers=" + part, "--pairs=20")
        found, _ = run.benchmark(letter, "--data=" + run.scratch, "--problem=" + letter, run.times(3),
                                    "--methods=USACV20,USACV20_FAST," + flag)
        body += "\n%s\n" % tables.against(found, ["USACV20", "USACV20_FAST"], flag)
    return body


def measure_rigid(run):
    body = ("Noise of half a unit; the cloud of points is 200 units wide; uniform wrong matches, 20 pairs per list. The names "
            "of lists have the number of matches and the fraction of right ones. Error: angle between the rotations in degrees, "
            "median / failures in %; CPU time: median.\n")
    for letter, scene in (("R", "rigid"), ("M", "rigidScaled")):
        for size in (200, 1000, 10000):
            for part in ("0.1", "0.2", "0.5", "0.8"):
                run.scenes(scene, "%s_%d_%s" % (scene, size, part), "--inliers=" + part, "--size=%d" % size, "--pairs=20")
        found, _ = run.benchmark(letter, "--data=" + run.scratch, "--problem=" + letter, run.times(3),
                                    "--methods=USACV20,USACV20_FAST,cv:AFFINE3D,cv:AFFINE3D_REFIT")
        body += "\n%s\n" % tables.against(found, ["USACV20", "USACV20_FAST", "cv:AFFINE3D_REFIT"], "cv:AFFINE3D")
    return body


def measure_tracking(run):
    run.repeats = run.chosen or 5
    run.call("usac_tracking", "--sequences=%d" % run.repeats, "--limits=8,32", "--csv=" + run.path("tracking.csv"))
    return ("Median error (P degrees, H pixels) / failures in % of the frames / samples per frame / ratio of the CPU time to "
            "that with the default limit without a model / failed frames after the jump until the first success.\n\n" +
            tables.tracking(run.path("tracking.csv")))


def measure_scale(run):
    text = run.call("scale.py", "--program=" + os.path.join(run.build, "bin", "usac_benchmark"), run.times(5), "--limit=1500",
                    "--csv=" + run.path("scale.csv"))
    run.call("plot_scale.py", run.path("scale.csv"), "--out=" + run.scratch, shown=False)
    for picture in ("scale_time", "scale_error"):
        shutil.copy(run.path(picture + ".png"), os.path.join(ROOT, FOLDER, picture + ".png"))
    return re.sub(r"\A# .*\n+", "", text)


def measure_threads(run):
    found, _ = run.two_views(("USACV20", "USACV20_PARALLEL"), run.times(3), "--threads=2")
    rows = [["%s %s" % key, "%.2f" % (t["USACV20"]["mean_wall_ms"] / t["USACV20_PARALLEL"]["mean_wall_ms"])] for key, t in found.items()]
    return ("Mean wall time of `USACV20`, divided by that of `USACV20_PARALLEL`; meaningless if other programs use the "
            "processors.\n\n" + tables.markdown(["list", "times faster"], rows, True))


def measure_covariance(run):
    """Measures how well Report::covariance describes the errors on synthetic scenes."""
    run.repeats = 1
    text = run.call("usac_covariance", "--scenes=%d" % (run.chosen or 10000), "--by=problem,shape,size,noise")
    return ("Scenes of each problem, the same number for each combination of shape, number of matches (20 to 1000), fraction of "
            "right matches (10 to 95 %; F, E: 30 to 95 %) and noise (standard deviation of each component of 0.1, 0.3 and 1 "
            "thresholds). Wrong: models with a root mean square error of more than a threshold on the noise-free right matches. "
            "For the other models, mean / d: mean squared Mahalanobis distance of the true model, divided by the number of "
            "parameters, aim 0.9 to 1.1; within 95 %: percentage of the true models in the 95 % confidence region, aim 93 to "
            "97 %; noise: mean ratio of `Report::sigma` to the true noise. planeN: N percent of the right matches are on a "
            "plane.\n\n" + text)


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
            text.strip() +
            "\n\nThe same if each point of an image has five times this noise in a random direction, and the estimator gets the "
            "covariances of the points.\n\n" + directed)


Kind = collections.namedtuple("Kind", "title measure")
KINDS = collections.OrderedDict((
    ("lists", Kind("H, F and E on public lists and synthetic scenes", measure_lists)),
    ("threshold", Kind("Sensitivity to the threshold", measure_threshold)),
    ("automatic", Kind("The estimated threshold", measure_automatic)),
    ("pose", Kind("Absolute pose", measure_pose)),
    ("affine", Kind("Affinities and similarities", measure_affine)),
    ("rigid", Kind("Rigid motions of space", measure_rigid)),
    ("tracking", Kind("A model for the next frame", measure_tracking)),
    ("scale", Kind("Time over size and hardness", measure_scale)),
    ("covariance", Kind("How sure: the calibration of the covariance", measure_covariance)),
    ("sigmas", Kind("The noise of each match", measure_sigmas)),
    ("threads", Kind("Two threads", measure_threads))))
STRUCTURED = "structured_tables"  # its tables are the output of the commands that the file itself has
PROGRAMS = ("usac_benchmark", "usac_covariance", "usac_structured", "usac_synthetic", "usac_tracking")


def state():
    """Returns the commit of the sources, with a remark if C++ files in the working tree differ from
    this commit."""
    changed = git("status", "--porcelain", "--", "modules/usac/src", "modules/usac/include", "modules/usac/benchmark")
    return (git("rev-parse", "--short", "HEAD") or "-") + (" and changes" if re.search(r"\.[ch]pp$", changed, re.M) else "")


def today():
    return "%s" % datetime.datetime.now(datetime.timezone.utc).date()


def measure(name, build, data, repeats):
    kind = KINDS[name]
    with tempfile.TemporaryDirectory() as scratch:
        run = Run(build, data, repeats, scratch)
        clock, before = datetime.datetime.now(), processor_times()
        body = kind.measure(run)
        words = busy_words(before, processor_times(), (datetime.datetime.now() - clock).total_seconds())
        stamp = {"command": "`%s`" % "; ".join(run.commands), "commit": state(), "date": today(), "machine": machine_name() + words,
                 "OpenCV": run.opencv, "repeats": str(run.repeats)}
        Measurement(name, kind.title, stamp, body).write()


def measure_structured(build, sections):
    """Runs the commands in these sections of structured_tables.md, or in all sections if the list is
    empty, and replaces the tables."""
    m = Measurement.read(STRUCTURED)
    run = Run(build, "", None, "")
    m.body = structured_tables.renewed(m.body, sections, state(), lambda arguments: run.call(structured_tables.PROGRAM, *arguments))
    m.stamp.update({"date": today(), "OpenCV": run.opencv})
    m.write()


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(list(KINDS) + [STRUCTURED]))
    parser.add_argument("--build", metavar="DIR", required=True)
    parser.add_argument("--data", metavar="DIR", help="needed by lists, threshold, automatic, pose and threads")
    parser.add_argument("--repeats", type=int, help="number of repeats, instead of the default of each measurement")
    parser.add_argument("--section", action="append", default=[])
    options = parser.parse_args(arguments)
    names = options.names or ["lists"]
    try:
        unknown = [name for name in names if name not in KINDS and name != STRUCTURED]
        if unknown:
            raise MeasureError("no measurement %s" % ", ".join(unknown))
        subprocess.run(["cmake", "--build", options.build, "--target"] + list(PROGRAMS), check=True, stdout=sys.stderr)
        for name in names:
            if name == STRUCTURED:
                measure_structured(options.build, options.section)
            else:
                measure(name, options.build, options.data, options.repeats)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
