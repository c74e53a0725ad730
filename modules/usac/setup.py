# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Builds the Python package usacv20: `pip install modules/usac`.

CMake compiles the extension module (misc/python/native). Environment variables: CMAKE_ARGS: options
for CMake; CMAKE_BUILD_PARALLEL_LEVEL: number of jobs; USACV20_BUILD_DIR: build folder, which is
then kept."""

import atexit
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

OLDEST = (3, 8)
if sys.version_info[:2] < OLDEST:
    sys.exit("usacv20: Python %d.%d or later is needed, this is %d.%d" % (OLDEST + tuple(sys.version_info[:2])))

from setuptools import Extension, setup  # noqa: E402
from setuptools.command.build_ext import build_ext  # noqa: E402
from setuptools.errors import SetupError  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
EGG_INFO = os.path.join(HERE, "misc", "python", "package", "usacv20.egg-info"), os.path.join(HERE, "usacv20.egg-info")


def version():
    """Returns the version of the C++ library."""
    with open(os.path.join(HERE, "cmake", "usac_version.cmake")) as file:
        return re.search(r"set\(USAC_VERSION ([0-9.]+)\)", file.read()).group(1)


def temporary():
    """Makes a folder for this build, which is removed when this script ends."""
    folder = tempfile.mkdtemp(prefix="usacv20-build-")
    atexit.register(shutil.rmtree, folder, True)
    return folder


def alone():
    """Waits until no other build of the same sources is running, because setuptools writes files
    next to the sources, and each build removes these files at its end. Returns a file that holds
    the lock while it is open. Without fcntl (Windows) or locks in the file system, there is no
    lock."""
    file = open(os.path.join(HERE, "pyproject.toml"))
    try:
        import fcntl
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            print("usacv20: waiting for another build of the same sources", file=sys.stderr, flush=True)
            fcntl.flock(file, fcntl.LOCK_EX)
    except (ImportError, OSError):
        pass
    return file


def remove_later(folders):
    """Registers those of the folders that do not exist yet for removal at the end of this script:
    setuptools makes them next to the sources and leaves them there."""
    for folder in folders:
        if not os.path.exists(folder):
            atexit.register(shutil.rmtree, folder, True)


def borrow_license():
    """Copies the license from the project's folder to the folder of this script, because setuptools
    packs only files of this folder. The copy is removed when the script ends."""
    copy, text = os.path.join(HERE, "LICENSE"), os.path.join(HERE, "..", "..", "LICENSE")
    if not os.path.exists(copy) and os.path.exists(text):
        shutil.copyfile(text, copy)
        atexit.register(os.remove, copy)


def pybind11():
    """Returns the requirement for pybind11 if pip must install it for this build, otherwise an empty
    list. If pip installs pybind11, it also installs NumPy 2, which needs pybind11 2.12."""
    try:
        import numpy  # noqa: F401
    except ImportError:  # in an environment that pip has made for this build
        return ["pybind11 >= 2.12"]
    return []


class Native(build_ext):
    """Builds the extension module with CMake. If something is missing, the error message is a single line."""

    def build_extension(self, extension):
        build = os.environ.get("USACV20_BUILD_DIR") or os.path.join(temporary(), "native")
        if not shutil.which("cmake"):
            raise SetupError("usacv20: CMake was not found (Debian: cmake)")
        self.run_cmake(["cmake", "-S", os.path.join(HERE, "misc", "python", "native"), "-B", build,
                        "-DPython_EXECUTABLE=" + sys.executable, "-DUSAC_PYBIND11_DIR=" + self.pybind11()]
                       + shlex.split(os.environ.get("CMAKE_ARGS", "")))
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        self.run_cmake(["cmake", "--build", build, "--config", "Release", "--parallel", jobs])
        target = self.get_ext_fullpath(extension.name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        out = os.path.join(build, "out")
        self.copy_file(os.path.join(out, next(name for name in os.listdir(out) if name.startswith("_native."))), target)

    def pybind11(self):
        """Returns the folder of the CMake files of pybind11 if it is installed for this Python,
        otherwise an empty string."""
        found = subprocess.run([sys.executable, "-m", "pybind11", "--cmakedir"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return found.stdout.decode().strip()

    def run_cmake(self, command):
        run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        lines = []
        for line in run.stdout:
            lines.append(line.rstrip())
            if self.verbose > 1 or os.environ.get("VERBOSE"):
                print(lines[-1], flush=True)
        if run.wait() == 0:
            return
        missing = [line.strip() for line in lines if line.strip().startswith("usacv20: ")]
        if missing:
            raise SetupError(missing[0])
        print("\n".join(lines[-60:]), file=sys.stderr)
        wrong = [line.strip() for line in lines if "error" in line.lower()] or lines[-1:]
        raise SetupError("usacv20: {} has failed: {}".format(" ".join(command[:2]), wrong[0] if wrong else "no output"))


lock = alone()
remove_later(EGG_INFO)
borrow_license()
setup(
    version=version(),
    license="Apache-2.0",
    ext_modules=[Extension("usacv20._native", sources=[])],
    cmdclass={"build_ext": Native},
    setup_requires=pybind11(),
    options={"build": {"build_base": temporary()}},
)
