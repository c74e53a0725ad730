#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Builds the module against the OpenCV of the system and runs five of its samples on OpenCV's own
# images. Most samples compare the module with OpenCV's own methods (errors if the truth is known,
# inliers, iterations and milliseconds) and write a picture. Then this script installs the Python
# package in a virtual environment and runs its samples. On Debian, it first installs the packages
# that it needs (as root or with sudo).
#
#   USAC_BUILD_DIR            folder for all files that this script writes; default
#                             ${TMPDIR:-/tmp}/opencv_usac_quickstart
#   CMAKE_ARGS                further options for the build of the Python package
#   OPENCV_SAMPLES_DATA_PATH  folder of OpenCV's sample images; default: the one of Debian's package
#                             opencv-doc

set -eu
[ $# = 0 ] || { echo "usage: quickstart.sh" >&2; exit 2; }
project=$(cd "$(dirname "$0")/.." && pwd)
work=${USAC_BUILD_DIR:-${TMPDIR:-/tmp}/opencv_usac_quickstart}
packages="g++ make cmake libeigen3-dev libopencv-dev pybind11-dev python3-dev python3-venv python3-setuptools python3-wheel
    python3-opencv python3-matplotlib"
files="graf1.png graf3.png H1to3p.xml aloeL.jpg aloeR.jpg aloeGT.png left01.jpg right01.jpg stereo_calib.xml box.png box_in_scene.png"
pictures=$work/pictures
mkdir -p "$pictures"
build=$work/build-$(printf %s "$project" | cksum | cut -d " " -f 1)

finished=no
trap '[ $finished = yes ] || echo "quickstart: failed" >&2' EXIT

as_root()
{
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages()
{
    missing=
    for p in $packages; do
        dpkg-query -W -f '${db:Status-Status}\n' "$p" 2>/dev/null | grep -q '^installed' || missing="$missing $p"
    done
    [ -n "$missing" ] || return 0
    echo "== installing$missing"
    as_root apt-get update
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

has_images()
{
    for f in $files; do
        [ -f "$1/$f" ] || return 1
    done
}

# Only the images of the package are unpacked: the package is large, and minimal systems do not
# install files in /usr/share/doc.
fetch_images()
{
    echo "== fetching OpenCV's sample images"
    mkdir -p "$work/opencv-doc"
    cd "$work/opencv-doc"
    [ -n "$(apt-cache show opencv-doc 2>/dev/null)" ] || as_root apt-get update
    apt-get -o APT::Sandbox::User=root download opencv-doc
    dpkg-deb --fsys-tarfile opencv-doc_*.deb | tar -x --wildcards '*/examples/data/*'
    rm opencv-doc_*.deb
    cd "$project"
}

find_images()
{
    for folder in "${OPENCV_SAMPLES_DATA_PATH:-}" /usr/share/doc/opencv-doc/examples/data; do
        if has_images "$folder"; then images=$folder; return; fi
    done
    images=$work/opencv-doc/usr/share/doc/opencv-doc/examples/data
    has_images "$images" || fetch_images
    has_images "$images"
}

build()
{
    echo "== building"
    cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release > "$work/configure.log" 2>&1 ||
        { cat "$work/configure.log"; return 1; }
    cmake --build "$build" -j "$(nproc)" --target example_usac_homography example_usac_fundamental \
        example_usac_essential example_usac_absolute_pose example_usac_custom_sampler
}

sample() # name, arguments
{
    echo
    echo "== $1"
    program=$build/bin/example_usac_$1
    shift
    OPENCV_SAMPLES_DATA_PATH=$images "$program" "$@"
}

python_sample() # name, arguments
{
    echo
    echo "== $1.py"
    program=$project/samples/python/$1.py
    picture=$pictures/$1_py.png
    shift
    OPENCV_SAMPLES_DATA_PATH=$images "$work/venv/bin/python3" "$program" "$@" --output="$picture"
}

# The package uses the existing build of the library; without opencv_usac_DIR, pip would compile the
# library again.
python_package()
{
    echo
    echo "== the Python package"
    rm -rf "$work/venv"
    /usr/bin/python3 -m venv --system-site-packages "$work/venv"
    CMAKE_ARGS="-Dopencv_usac_DIR=$build ${CMAKE_ARGS:-}" "$work/venv/bin/pip" install --quiet --no-build-isolation --no-index "$project/modules/usac"
    python_sample homography
    python_sample fundamental
    python_sample essential
    python_sample absolute_pose box.png
    python_sample stabilize
    python_sample walkthrough
}

if command -v dpkg-query > /dev/null; then install_packages; fi
find_images
build
sample homography --output="$pictures/homography.jpg"
sample fundamental --output="$pictures/fundamental.jpg"
sample essential --output="$pictures/essential.jpg"
sample absolute_pose box.png --output="$pictures/absolute_pose.jpg"
sample custom_sampler
python_package
finished=yes
echo
echo "Pictures: $pictures"
