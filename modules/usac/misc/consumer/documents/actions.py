# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Actions that run or check a block of code of a document. An action has a method run(place, block),
which raises Wrong if the block fails."""

import json
import os
import shutil
import subprocess
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from blocks import Block, commandsOf

HERE = os.path.dirname(os.path.abspath(__file__))
UNUSED = "Manually-specified variables were not used by the project"
DEADLINE = 1200  # time limit, in seconds, of each process that Place.call() runs


class Wrong(Exception):
    """Raised if a block does not do what its document says."""


class Place:
    """The folders in which blocks run, within the folder `documents` of the constructor's `work`. `work`
    is the working directory of check.sh, which has built and installed the library there.

        clone                  a folder as after a checkout: links to the files and folders of the project;
                               `build` is a link to the library's build
        collection, benchmark  folders for blocks on collections and on the benchmark
        programs, python       folders for blocks in C++ and in Python
        prefix                 folder into which blocks install the library
        bin                    programs that replace cmake, apt, apt-get and sudo (stand_in.py), and a link
                               to the system's python3"""

    def __init__(self, project: str, work: str, opencv: str = "") -> None:
        self.project, self.checks, self.opencv = os.path.realpath(project), os.path.realpath(work), opencv
        self.build = os.path.join(self.checks, "build")
        self.work = os.path.join(self.checks, "documents")
        for name in ("clone", "collection", "prefix", "bin", "python", "benchmark"):
            shutil.rmtree(self.folder(name), ignore_errors=True)
        for name in ("clone", "collection", "prefix", "bin", "python", "benchmark", "programs"):
            os.makedirs(self.folder(name), exist_ok=True)
        for name in os.listdir(self.project):
            if name not in (".git", "build", "env"):
                os.symlink(os.path.join(self.project, name), self.folder("clone", name))
        os.symlink(self.build, self.folder("clone", "build"))
        for name in ("cmake", "apt", "apt-get", "sudo"):
            os.symlink(os.path.join(HERE, "stand_in.py"), self.folder("bin", name))
        os.symlink("/usr/bin/python3", self.folder("bin", "python3"))

    def folder(self, *names: str) -> str:
        return os.path.join(self.work, *names)

    def environment(self, *path: str, **variables: str) -> Dict[str, str]:
        """Returns the environment variables of a process. `path` names the folders in which programs
        are searched for first."""
        folders = [*path, self.folder("bin"), os.path.join(self.build, "bin"), os.environ["PATH"]]
        return dict(os.environ, PATH=os.pathsep.join(folders), USAC_DOCUMENTS_PROJECT=self.project, PYTHONDONTWRITEBYTECODE="1",
                    MPLBACKEND="Agg", **variables)

    def call(self, command: Sequence[str], cwd: str, environment: Optional[Dict[str, str]] = None) -> str:
        """Runs a command; returns its output and error stream. Raises Wrong if the command fails, takes
        longer than DEADLINE, or prints CMake's warning of an unused option."""
        try:
            run = subprocess.run(command, cwd=cwd, env=environment or self.environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, universal_newlines=True, errors="replace", timeout=DEADLINE)
        except subprocess.TimeoutExpired as error:
            raise Wrong("no end within {} s\n{!r}".format(DEADLINE, error.stdout)) from error
        except OSError as error:
            raise Wrong(str(error)) from error
        if run.returncode:
            raise Wrong("{}\nexit code {}".format(run.stdout, run.returncode))
        if UNUSED in run.stdout:
            raise Wrong("{}\nan option that the project does not know".format(run.stdout))
        return run.stdout


class Skipped(NamedTuple):
    """Action of a block that does not run here.

    reason -- why, or which other check or test runs it"""

    reason: str

    def run(self, place: Place, block: Block) -> None:
        pass


class Shell(NamedTuple):
    """Runs the commands of a shell block in one shell.

    where -- folder of Place in which they run
    names -- replacements for words of the text such as <prefix>. In replacements, {work}, {build} and
    so on are replaced with folders
    variables, path -- environment variables, and folders in which programs are searched for first
    without -- commands of the block that are not run here
    before -- commands that run before the block
    always -- commands that run at the end, even after a failure"""

    where: str = "clone"
    names: Dict[str, str] = {}
    variables: Dict[str, str] = {}
    path: Tuple[str, ...] = ()
    without: Tuple[str, ...] = ()
    before: str = ""
    always: str = ""

    def run(self, place: Place, block: Block) -> None:
        def filled(text: str) -> str:
            for name, value in (("{build}", place.build), ("{project}", place.project), ("{checks}", place.checks), ("{work}", place.work)):
                text = text.replace(name, value)
            return text

        commands = commandsOf(block.text)
        if not set(self.without) <= set(commands):
            raise Wrong("the table has a command that is not in the block")
        text = "\n".join(command for command in commands if command not in self.without)
        for name, value in self.names.items():
            if name not in text:
                raise Wrong("{!r} of the table is not in the block".format(name))
            text = text.replace(name, filled(value))
        folder = place.folder(self.where)
        environment = place.environment(*map(filled, self.path), **{name: filled(value) for name, value in self.variables.items()})
        if self.before:
            place.call(["sh", "-exc", filled(self.before)], folder, environment)
        try:
            place.call(["sh", "-exc", text], folder, environment)
        finally:
            if self.always:
                place.call(["sh", "-exc", filled(self.always)], folder, environment)


class Cpp(NamedTuple):
    """Compiles a part of a C++ program, with warnings as errors, and runs it. frame.hpp defines the
    variables that the part uses.

    before -- code that is inserted before the part
    within -- {beginning of a line of the part: code that is inserted after this line}, for example to
    fill the reader's points after their declaration
    top -- code above main(), such as #include
    folders -- folders of the project with headers"""

    before: str = ""
    within: Dict[str, str] = {}
    top: str = ""
    folders: Tuple[str, ...] = ()

    def source(self, block: Block) -> str:
        lines, top = [], ['#include "frame.hpp"', self.top]
        left = dict(self.within)
        for line in block.text.rstrip("\n").split("\n"):
            if line.startswith("#include "):
                top.append(line)
                line = ""
            more = [left.pop(begin) for begin in list(left) if line.strip().startswith(begin)]
            lines.append(" ".join([line.split("//")[0] if more else line, *more]))
        if left:
            raise Wrong("the block has no line {!r} of the table".format(list(left)))
        return "{}\n\nint main()\n{{\n{}\n#line {} \"{}\"\n{}\nreturn 0;\n}}\n".format(
            "\n".join(top), self.before, block.line, block.document, "\n".join(lines))

    def run(self, place: Place, block: Block) -> None:
        place.call(["cmake", "--build", place.folder("programs"), "--target", block.name], place.work)
        place.call([place.folder("programs", "bin", block.name)], place.folder("programs"))


class Python(NamedTuple):
    """Runs a part of a Python program. frame.py defines the variables that the part uses.

    before -- code that runs before the part
    cv2 -- true: the part calls functions of cv2 with the flags of the module
    where -- folder of Place in which the part runs"""

    before: str = ""
    cv2: bool = False
    where: str = "python"

    def run(self, place: Place, block: Block) -> None:
        before, python, variables = self.before, place.folder("clone", "env", "bin", "python3"), {}
        loader = os.path.join(place.opencv, "python_loader") if place.opencv else ""
        if self.cv2 and os.path.isdir(loader):
            python, variables = "/usr/bin/python3", {"PYTHONPATH": loader}
        elif self.cv2:  # without a build of OpenCV with the module, usacv20.patch_cv2() makes the installed cv2 accept the flags
            before = ("import cv2, usacv20\nusacv20.patch_cv2()\ncv2.usacv20 = usacv20\n"
                      "for name in dir(usacv20):\n    if name.startswith('USACV20'): setattr(cv2, name, getattr(usacv20, name))\n") + before
        task = place.folder("python", block.name + ".json")
        with open(task, "w", encoding="utf-8") as file:
            json.dump(dict(document=block.document, line=block.line, code=block.text, before=before), file)
        out = place.call([python, os.path.join(HERE, "frame.py"), task], place.folder(self.where), place.environment(**variables))
        if "DONE" not in out:
            raise Wrong(out)


class CMake(NamedTuple):
    """Makes a CMake project from a block with lines of a CMakeLists.txt. These lines are appended to
    lines that define a target `program`.

    options -- options of the configuration
    names -- replacements for words of the text
    links -- {name: target} of symbolic links that are made in the folder of the project
    build -- true: the program is built and run; false: the project is only configured
    whole -- if not empty, the block is a complete CMakeLists.txt, and this word in it is replaced by
    the path of main.cpp"""

    options: Tuple[str, ...] = ()
    names: Dict[str, str] = {}
    links: Dict[str, str] = {}
    build: bool = True
    whole: str = ""

    def run(self, place: Place, block: Block) -> None:
        folder = place.folder("cmake_" + block.name)
        os.makedirs(folder, exist_ok=True)
        for name in ("CMakeCache.txt", *self.links):
            if os.path.lexists(os.path.join(folder, name)):
                os.remove(os.path.join(folder, name))
        for name, target in self.links.items():
            os.symlink(target.replace("{project}", place.project), os.path.join(folder, name))
        main, text = os.path.join(os.path.dirname(HERE), "main.cpp"), block.text
        for name, value in {**self.names, **({self.whole: main} if self.whole else {})}.items():
            if name not in text:
                raise Wrong("{!r} of the table is not in the block".format(name))
            text = text.replace(name, value.replace("{project}", place.project))
        write(os.path.join(folder, "CMakeLists.txt"), text if self.whole else
              "cmake_minimum_required(VERSION 3.14)\nproject(documents CXX)\nadd_executable(program {})\n{}".format(main, text))
        made = os.path.join(folder, "build")
        options = [option.replace("{checks}", place.checks).replace("{work}", place.work) for option in self.options]
        place.call(["cmake", "-S", folder, "-B", made, *options], folder)
        if self.build:
            place.call(["cmake", "--build", made], folder)
            place.call([os.path.join(made, "program")], folder)


def write(path: str, text: str) -> None:
    """Writes a file only if its text changes, so that files made from it stay up to date."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def preparePrograms(place: Place, programs: List[Tuple[Block, Cpp]]) -> None:
    """Makes one CMake project from all C++ programs and builds it. Programs that are up to date are not
    compiled again. Errors of the build are ignored here, because the actions of the programs build
    again and report them."""
    folder = place.folder("programs")
    os.makedirs(os.path.join(folder, "source"), exist_ok=True)
    lines = ["cmake_minimum_required(VERSION 3.13)", "project(documents CXX)", "find_package(opencv_usac REQUIRED)",
             "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)", "add_compile_options(-Wall -Wextra -Werror -Wno-unused)"]
    for block, action in programs:
        write(os.path.join(folder, "source", block.name + ".cpp"), action.source(block))
        lines += ["add_executable({0} {0}.cpp)".format(block.name), "target_link_libraries({} opencv_usac::opencv_usac)".format(block.name),
                  "target_include_directories({} PRIVATE {} {})".format(
                      block.name, HERE, " ".join(os.path.join(place.project, name) for name in action.folders))]
    write(os.path.join(folder, "source", "CMakeLists.txt"), "\n".join(lines) + "\n")
    place.call(["cmake", "-S", os.path.join(folder, "source"), "-B", folder, "-Dopencv_usac_DIR=" + place.build], place.work)
    subprocess.run(["cmake", "--build", folder, "-j", str(os.cpu_count()), "--", "-k" + ("0" if os.path.exists(
        os.path.join(folder, "build.ninja")) else "")], cwd=place.work, env=place.environment(), stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, check=False)
