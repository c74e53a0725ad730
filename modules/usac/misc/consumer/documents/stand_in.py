#!/usr/bin/python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Replaces cmake, apt, apt-get and sudo when commands of the documents run.

cmake: runs the real cmake with two arguments changed. The folder of -S, if it is the scratch
checkout, becomes the folder of the project. The folder of -B, if it is a symbolic link, becomes the
target of the link, which is the existing build.
apt install: installs nothing. Packages must be installed already. Package files must be installable,
which is tested by a simulation.
apt-get: only `download` and `update`, which scripts need, are allowed.
sudo: only `sudo apt` is allowed. It does the same as apt above, without the rights of root."""

import os
import subprocess
import sys

PROJECT = os.environ.get("USAC_DOCUMENTS_PROJECT", "")


def elsewhere(name):
    """Returns the path of the real program with this name."""
    for folder in os.environ["PATH"].split(os.pathsep):
        path = os.path.join(folder, name)
        if os.path.realpath(path) != os.path.realpath(__file__) and os.access(path, os.X_OK):
            return path
    sys.exit(name + " was not found")


def cmake(arguments):
    for flag in ("-S", "-B"):
        if flag in arguments[:-1]:
            k = arguments.index(flag) + 1
            path = arguments[k]
            if flag == "-B" and os.path.islink(path):
                arguments[k] = os.path.realpath(path)
            elif flag == "-S" and os.path.realpath(os.path.join(path, "CMakeLists.txt")) == os.path.join(PROJECT, "CMakeLists.txt"):
                arguments[k] = PROJECT
    program = elsewhere("cmake")
    os.execv(program, [program] + arguments)


def apt(arguments):
    if arguments[:1] != ["install"]:
        sys.exit("not a command for a document: apt " + " ".join(arguments))
    files = [name for name in arguments[1:] if os.path.isfile(name)]
    names = [name for name in arguments[1:] if name not in files and not name.startswith("-")]
    if not files + names:
        sys.exit("apt install: nothing to install")
    for name in names:
        status = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status}", name], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True).stdout
        if status != "installed":
            sys.exit("apt install: {} is not installed: {}".format(name, status))
    if files:
        os.execv("/usr/bin/apt-get", ["apt-get", "--simulate", "install", *map(os.path.abspath, files)])


def main(name, arguments):
    if name == "cmake":
        cmake(arguments)
    elif name == "apt":
        apt(arguments)
    elif name == "apt-get":
        if not {"download", "update"} & set(arguments):
            sys.exit("a package is missing: apt-get " + " ".join(arguments))
        os.execv("/usr/bin/apt-get", ["apt-get"] + arguments)
    elif arguments[:1] == ["apt"]:  # the program is sudo
        apt(arguments[1:])
    else:
        sys.exit("not a command for a document: sudo " + " ".join(arguments))


if __name__ == "__main__":
    main(os.path.basename(sys.argv[0]), sys.argv[1:])
