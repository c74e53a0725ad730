#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Writes the parts of the package that repeat C++ declarations: package/usacv20/_enumerations.py,
_problems.py and a list of names in __init__.py.

 make_names.py          writes them
 make_names.py --check  prints which of these parts are out of date, and where the table of problems
                        (src/problems/registry.inl.hpp) and the declarations in the public headers
                        differ

Enumerators and their comments come from the headers. Each row of the table of problems becomes two
functions in _problems.py: one for a single estimation and one for many estimations. In their
docstrings, the descriptions of model and threshold come from the comment of the C++ declaration in
estimate.hpp; the other text depends on the kind of the arguments (class Arguments)."""

import os
import re
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
MODULE = os.path.dirname(os.path.dirname(HERE))
HEADERS = os.path.join(MODULE, "include", "opencv2", "usac")
PACKAGE = os.path.join(HERE, "package", "usacv20")
WIDTH = 127
LICENSE = """# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""
MADE = "# Written by misc/python/make_names.py. Edit that script or the headers instead of this file.\n\n"


def read(*path):
    with open(os.path.join(*path)) as file:
        return file.read()


# --- reading the headers and the table of problems --------------------------------------------------------------------------

def plain(comment):
    """Converts a Doxygen comment to plain text with Python names."""
    text = re.sub(r"(?m)^\s*(//!<|//!|//|/\*\*|\*/)|\*/", " ", comment)
    text = re.sub(r"@brief |@cite \w+| \(paper,\s+section\s+\"[^\"]*\"\)", "", " ".join(text.split()))
    text = re.sub(r"@ref |#(?=[A-Za-z])|usacv20::", "", text).replace("cv::Exception", "usacv20.error")
    text = text.replace("`", "").replace("cv::", "cv2.").replace("::", ".")
    return re.sub(r" +([.,;:]|$)", r"\1", " ".join(text.split()))


def sentence(comment):
    """Returns the first sentence of a comment as plain text, without the period."""
    return re.split(r"\.(?:\s|$)", plain(comment))[0]


def short(comment):
    """Returns the comment of an enumerator as plain text. If the text has the length of two lines or
    more, only its first sentence is returned."""
    text = plain(comment)
    return text if len(text) < 2 * WIDTH else sentence(comment)


class Enumeration:
    """An enumeration of a C++ header: name, comment and members (name, value, comment)."""

    def __init__(self, name, comment, body):
        self.name, self.comment, self.members = name, comment, []
        pattern = r"\s*((?:(?://!(?!<).*\n\s*)|(?:/\*\*(?:.|\n)*?\*/\s*))*)(\w+) = (\w+),?((?:\s*//!<.*)*)"
        for before, member, value, after in re.findall(pattern, body):
            self.members.append((member, value, short(before or after)))


def enumerations():
    found = []
    pattern = r"((?://!.*\n)+|/\*\*(?:(?!\*/)(?:.|\n))*\*/\n)enum (?:class )?(\w+)[ :\w]*\{\n((?:.|\n)*?)\n\};"
    for header in ("params.hpp", "report.hpp", "two_view_geometry.hpp"):
        for comment, name, body in re.findall(pattern, read(HEADERS, header)):
            found.append(Enumeration(name, sentence(comment), body))
    return found


class Arguments:
    """The arguments of the functions of a kind of problem, except options such as params and mask.
    The column ARGUMENTS of the table of problems names the kind.

    cpp, many -- names of the arguments in C++, for a single estimation and for many estimations
    python, pythonMany -- declarations of these arguments in Python
    about, aboutMany -- descriptions of these arguments in the docstrings
    call, callMany -- the arguments, with options, in the call of estimate() and estimateMany()
    names -- constant with the argument names for error messages; empty: the default names
    forms -- forms of the call, for the docstring, if the Python declaration does not show them
    prepare -- code that converts the arguments of these forms to the declared arguments"""

    def __init__(self, cpp, many, about, optional=(), names="", prepare="", forms=""):
        self.cpp, self.many, self.about, self.names, self.prepare, self.forms = cpp, many, about, names, prepare, forms
        points, rest = cpp[:2], cpp[2:]
        types = {name: "Optional[npt.ArrayLike] = None" if name in optional else "npt.ArrayLike" for name in cpp}
        if prepare:
            types["cameraMatrix2"] = "Union[npt.ArrayLike, Params, None] = None"
        self.python = ["{}: {}".format(name, types[name]) for name in cpp]
        self.pythonMany = ["{}: _Lists".format(name) for name in points] + [
            "{}: _Arrays{}".format(name, " = None" if one in optional or one == "cameraMatrix2" else "")
            for one, name in zip(rest, many[2:])]
        self.aboutMany = ("\n\n" + ", ".join(many[2:]) + " -- one array for all estimations, or a list with an array for each. A camera matrix "
                          "is a 3x3 array" + ("; None for image 2: the same as for image 1" if len(many) == 6 else "") +
                          ". Distortion coefficients None: no distortion"
                          ) if rest else ""
        one, two = (cpp[2:4], cpp[4:]) if len(cpp) == 6 else (cpp[2:3], cpp[3:])  # camera matrices, distortion coefficients
        self.call = list(points) + ["params", "mask"] + list(one) + (["None"] if len(cpp) == 4 else []) + list(two)
        self.callMany = list(points) + ["params", "threads", "returnExceptions"] + list(many[2:])
        if len(cpp) == 4:
            self.callMany[6:6] = ["None"]


POINTS = ("points1, points2 -- N points of each image{}: Nx2, 2xN, Nx1x2 or 1xNx2, integers or floating-point numbers of any type and "
          "memory layout. With 3 coordinates instead of 2, the points are homogeneous; a third column of numbers 0..1 that are not all 1 "
          "(confidences) raises usacv20.error")
ARGUMENTS = {
    "IMAGES": Arguments(("points1", "points2"), ("points1", "points2"), POINTS.format("")),
    "SPACES": Arguments(("points1", "points2"), ("points1", "points2"),
                        "points1, points2 -- N 3-D points and their N counterparts: Nx3, 3xN, Nx1x3 or 1xNx3"),
    "CAMERAS": Arguments(
        ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2"),
        ("points1", "points2", "cameraMatrices1", "cameraMatrices2", "distCoeffs1", "distCoeffs2"),
        POINTS.format(" in pixels") + "\ncameraMatrix1, cameraMatrix2 -- 3x3 camera matrices of image 1 and image 2; cameraMatrix2 None: "
        "the same as cameraMatrix1\ndistCoeffs1, distCoeffs2 -- 4, 5, 8, 12 or 14 distortion coefficients of camera 1 and camera 2, as in "
        "cv2.undistortPoints; None: no distortion",
        optional=("distCoeffs1", "distCoeffs2"),
        prepare="    cameraMatrix2, distCoeffs1, params, mask = oneOrTwoCameras(cameraMatrix2, distCoeffs1, distCoeffs2, params, mask)\n",
        forms="\n{0}(points1, points2, cameraMatrix[, params[, mask]])\n{0}(points1, points2, cameraMatrix1, cameraMatrix2[, "
        "distCoeffs1[, distCoeffs2[, params[, mask]]]])\n"),
    "POSE": Arguments(
        ("objectPoints", "imagePoints", "cameraMatrix", "distCoeffs"),
        ("objectPoints", "imagePoints", "cameraMatrices", "distCoeffs"),
        "objectPoints -- N 3-D points: Nx3, 3xN, Nx1x3 or 1xNx3\nimagePoints -- their N image points in pixels, in the forms of the points "
        "of estimateHomography\ncameraMatrix -- 3x3 camera matrix K\ndistCoeffs -- 4, 5, 8, 12 or 14 distortion coefficients, as in "
        "cv2.projectPoints; None: no distortion",
        optional=("distCoeffs",), names="POSE"),
}


class Problem:
    """A row of the table of problems (src/problems/registry.inl.hpp)."""

    def __init__(self, type, name, plural, arguments):
        self.type, self.function, self.batch, self.kind = type, "estimate" + name, "estimate" + plural, arguments
        self.arguments = ARGUMENTS[arguments]

    def documented(self):
        """Returns the brief description, the meaning of the threshold and the description of the
        model from the comment of the C++ declaration; None if one of the three is missing."""
        pattern = r"/\*\* @brief ((?:(?!\*/)(?:.|\n))*)\*/\nCV_EXPORTS Mat {}\(".format(self.function)
        found = re.search(pattern, read(HEADERS, "estimate.hpp"))
        if not found:
            return None
        parts = re.split(r"\n@(?=param|return)|\n\n", found.group(1))
        params = [part for part in parts if part.startswith("param params options; `threshold` is ")]
        model = [part for part in parts if part.startswith("return ")]
        if not params or not model or ", CV_64F, " not in plain(model[0]):
            return None
        meaning = plain(params[0])[len("param params options; threshold is "):].rstrip(".")
        shape, rest = plain(model[0])[len("return "):].split(", CV_64F, ")
        rest = re.sub(r"[;.] [Ee]mpty if there is none, and report says why", "; None if there is no model", rest).rstrip(".")
        return plain(parts[0]), meaning, "{} array of float64, {}".format(shape, rest)


def problems():
    rows = re.findall(r"(?m)^USACV20_PROBLEM\((\w+), (\w+), (\w+), (\w+)\)$", read(MODULE, "src", "problems", "registry.inl.hpp"))
    return [Problem(*row) for row in rows]


# --- writing the Python files ------------------------------------------------------------------------------------------------

def docstring(text, indent="    "):
    lines = []
    for line in text.split("\n"):
        hanging = "    " if " -- " in line else ""
        lines += textwrap.wrap(line, WIDTH - len(indent), subsequent_indent=hanging, break_long_words=False,
                               break_on_hyphens=False) or [""]
    return "\n".join([indent + '"""' + lines[0]] + [(indent + line) if line else "" for line in lines[1:]]) + '"""\n'


def wrapped(start, items, end):
    """Returns start + items + end, with commas between the items and line breaks where a line would
    be longer than WIDTH."""
    lines, line = [], start
    for i, item in enumerate(items):
        piece = item + (", " if i + 1 < len(items) else end)
        if len(line + piece.rstrip()) > WIDTH:
            lines.append(line.rstrip())
            line = " " * len(start)
        line += piece
    return "\n".join(lines + [line]) + "\n"


def listed(name, items):
    return "{}= [\n".format(name if name.endswith("+") else name + " ") + textwrap.fill(", ".join('"{}"'.format(item) for item in items), WIDTH, initial_indent="    ",
                                                   subsequent_indent="    ") + "]\n"


def enumerationsFile():
    found = enumerations()
    text = LICENSE + '"""The enumerations of the module. Each enumerator is also a constant of the package, such as usacv20.QUALITY_MSAC."""\n\n'
    text += MADE + "import enum\nfrom typing import Dict\n\n"
    names = sorted(member for enumeration in found for member, _, _ in enumeration.members)
    text += listed("__all__", names)
    for enumeration in found:
        base = "IntFlag" if enumeration.name.endswith("Flags") else "IntEnum"
        text += "\n\nclass {}(enum.{}):\n".format(enumeration.name, base) + docstring(enumeration.comment + ".") + "\n"
        for member, value, comment in enumeration.members:
            line = "    {} = {}  # {}".format(member, value, comment)
            if len(line) > WIDTH:
                line = textwrap.fill(comment, WIDTH, initial_indent="    # ", subsequent_indent="    # ",
                                     break_on_hyphens=False) + "\n" + line.split("  # ")[0]
            text += line + "\n"
    text += "\n\n"
    for enumeration in found:
        text += "".join("{0} = {1}.{0}\n".format(member, enumeration.name) for member, _, _ in enumeration.members)
    text += "\n#: The kind of the arguments of each problem: the column ARGUMENTS of src/problems/registry.inl.hpp.\nARGUMENTS: Dict[int, str] = {\n"
    text += "".join('    ProblemType.{}: "{}",\n'.format(problem.type, problem.kind) for problem in problems())
    return text + "}\n"


ESTIMATE = """{brief}
{forms}
{about}
params -- Params; None: the default. params.threshold is {threshold}
mask -- Nx1 array of uint8 or bool that receives the mask, or None

Returns (model, mask, report):
model -- {model}
mask -- Nx1 array of uint8, 1 for inliers
report -- Report; report.stop is the reason why the search ended, or why there is no model

Points with NaN or infinite coordinates are never inliers. A wrong argument raises usacv20.error, whose message names the \
argument."""

BATCH = """Runs {one} for many pairs of images in one call, in parallel.{about}

points1, points2 -- lists of the same length, with an entry for each estimation, in the forms that {one} accepts
params -- Params for all estimations, or a list with a Params (or None) for each, for example because match scores differ
threads -- number of estimations that run at once, at most the number of OpenCV's threads; 0: this number. The results do not \
depend on it
returnExceptions -- what happens if an entry is wrong, for example if its lists of points differ in length. True: the exception \
replaces the result of this entry. False: the exception of one such entry is raised and names the entry

Returns a list with (model, mask, report) for each entry, in the same order. Except for the times in the report, each result is \
bit-identical to that of {one}. If usacv20.progress stops the call, the mask of an entry that was not begun has the shape (0, 1). \
The global interpreter lock is released during the call."""


def functions(problem, first):
    """Returns the Python code of the two functions of a problem. The function for many estimations
    has a full docstring only for the first problem; those of the other problems refer to it."""
    brief, threshold, model = problem.documented()
    kind = problem.arguments
    options = ["params: Optional[Params] = None", "mask: _Mask = None"]
    names = ", names={}".format(kind.names) if kind.names else ""
    text = "\n\n" + wrapped("def {}(".format(problem.function), kind.python + options, ") -> _Estimate:")
    text += docstring(ESTIMATE.format(brief=brief, forms=kind.forms.format(problem.function), about=kind.about, threshold=threshold, model=model)) + kind.prepare
    text += wrapped("    return estimate(", ["ProblemType." + problem.type] + kind.call, names + ")")
    options = ["params: _ParamsOfEach = None", "threads: int = 0", "returnExceptions: bool = False"]
    names = ", names={}S".format(kind.names) if kind.names else ""
    text += "\n\n" + wrapped("def {}(".format(problem.batch), kind.pythonMany + options, ") -> _Estimates:")
    if problem.type == first.type:
        text += docstring(BATCH.format(one=problem.function, about=kind.aboutMany))
    else:
        text += docstring("Like {}, but runs {}.".format(first.batch, problem.function) + kind.aboutMany)
    return text + wrapped("    return estimateMany(", ["ProblemType." + problem.type] + kind.callMany, names + ")")


def problemsFile():
    rows = problems()
    text = LICENSE + '"""Two functions for each problem: one estimation with all options and a report, and many such estimations in one call."""\n\n'
    text += MADE + "from __future__ import annotations\n\nfrom typing import TYPE_CHECKING, Optional, Union\n\n"
    text += "from ._batch import POSES, estimateMany\nfrom ._enumerations import ProblemType\n"
    text += "from ._estimate import POSE, estimate, oneOrTwoCameras\nfrom ._params import Params\n\n"
    text += "if TYPE_CHECKING:\n    import numpy.typing as npt\n\n    from ._batch import _Arrays, _Estimates, _Lists, _ParamsOfEach\n"
    text += "    from ._estimate import _Estimate, _Mask\n\n"
    text += listed("__all__", sorted([row.function for row in rows] + [row.batch for row in rows]))
    return text + "".join(functions(row, rows[0]) for row in rows)


# --- checking the table against the headers ----------------------------------------------------------------------------------

def parameters(header, pattern, name):
    """Returns the names of the arguments in the first declaration of a function, without params,
    mask, report and threads; None if the function is not declared."""
    found = re.search(pattern + name + r"\(((?:[^()]|\(\))*)\);", header)
    if not found:
        return None
    names = [re.sub(r" = .*", "", part).split()[-1] for part in " ".join(found.group(1).split()).split(", ")]
    return tuple(name for name in names if name not in ("params", "mask", "report", "threads"))


def mistakes():
    """Returns messages on differences between the table and the public headers."""
    rows, found = problems(), []
    type_ = [enumeration for enumeration in enumerations() if enumeration.name == "ProblemType"][0]
    if [row.type for row in rows] != [member for member, _, _ in type_.members] or [
            value for _, value, _ in type_.members] != [str(i) for i in range(len(rows))]:
        found.append("registry.inl.hpp: the rows are not the enumerators of ProblemType, 0, 1, ... (params.hpp)")
    one, many = read(HEADERS, "estimate.hpp"), read(HEADERS, "batch.hpp")
    single, batch = r"CV_EXPORTS Mat ", r"CV_EXPORTS std::vector<Estimate> "
    for row in rows:
        if row.documented() is None:
            found.append("estimate.hpp: no comment of {} with @param params options; `threshold` is ..., and @return <shape>, CV_64F, "
                         "...".format(row.function))
        if parameters(one, single, row.function) != row.arguments.cpp:
            found.append("estimate.hpp: {} is not declared with the arguments {}".format(row.function, row.kind))
        if parameters(many, batch, row.batch) != row.arguments.many:
            found.append("batch.hpp: {} is not declared with the arguments {}".format(row.batch, row.kind))
    for header, text, pattern, names in (("estimate.hpp", one, single, {row.function for row in rows}),
                                         ("batch.hpp", many, batch, {row.batch for row in rows} | {"estimateBatch"})):
        found += ["{}: {} has no row in registry.inl.hpp".format(header, name)
                  for name in sorted(set(re.findall(pattern + r"(\w+)\(", text)) - names)]
    return found


def packageFile():
    """Returns the text of __init__.py with a list of all public names of _enumerations.py and
    _problems.py. The list is written out because type checkers do not evaluate expressions in
    __all__."""
    rows = problems()
    names = [member for enumeration in enumerations() for member, _, _ in enumeration.members]
    names += [row.function for row in rows] + [row.batch for row in rows]
    start, end = "# What follows is written by misc/python/make_names.py.\n", "# End of the names written by misc/python/make_names.py.\n"
    before, _, rest = read(PACKAGE, "__init__.py").partition(start)
    return before + start + listed("__all__ +", sorted(names)) + end + rest.partition(end)[2]


FILES = {"_enumerations.py": enumerationsFile, "_problems.py": problemsFile, "__init__.py": packageFile}


def main(check):
    found = mistakes()
    if found:
        return found
    for name, make in FILES.items():
        path, text = os.path.join(PACKAGE, name), make()
        if check and (not os.path.exists(path) or read(path) != text):
            found.append("{}: not as make_names.py writes it".format(name))
        elif not check:
            with open(path, "w") as file:
                file.write(text)
    return found


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    complaints = main(sys.argv[1:] == ["--check"])
    for complaint in complaints:
        print(complaint)
    sys.exit(1 if complaints else 0)
