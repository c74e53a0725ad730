#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Builds the library and its samples against the installed OpenCV, installs them into a temporary prefix, moves that, and
# builds and runs the consumer project by the CMake package and by pkg-config, and looks whether programs that would lose a flag
# are refused by the compiler. With a build of OpenCV that has the module inside, the same project is built and run against
# that, too: its build tree, and an installation that was moved. The last line is "<N> passed, <M> failed".
# usage: check.sh [working directory [build tree of OpenCV with the module]]

here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../../.." && pwd)
work=${1:-${TMPDIR:-/tmp}/opencv_usac_consumer}
opencv=${2:-}
version=$(sed -n 's/^set(USAC_VERSION \(.*\))$/\1/p' "$project/modules/usac/cmake/usac_version.cmake")
passed=0
failed=0

check() # name, command
{
    name=$1
    shift
    if "$@" > "$work/$name.log" 2>&1; then
        echo "PASSED $name"
        passed=$((passed + 1))
    else
        cat "$work/$name.log"
        echo "FAILED $name"
        failed=$((failed + 1))
    fi
}

install_library()
{
    cmake -S "$project" -B "$work/build" -DUSAC_WERROR=ON -DCMAKE_INSTALL_LIBDIR=lib &&
    cmake --build "$work/build" -j "$(nproc)" &&
    cmake --install "$work/build" --prefix "$work/staging" &&
    mv "$work/staging" "$work/prefix"
}

relocatable()
{
    [ -d "$work/prefix" ] && ! grep -rIF -e "$project" -e "$work" "$work/prefix"
}

# The one project for all ways; the package must be the one that is asked for, and the OpenCV, where that is known, its own. The
# libraries of an OpenCV that was moved need a path to find each other.
consumer() # name, option of CMake, directory of the package, directory of OpenCV's package or nothing, LD_LIBRARY_PATH or nothing
{
    cmake -S "$here" -B "$work/$1" "$2" > "$work/$1.cmake.log" 2>&1 || { cat "$work/$1.cmake.log"; return 1; }
    cat "$work/$1.cmake.log"
    grep -qF -e "-- opencv_usac $version of $3, OpenCV " "$work/$1.cmake.log" || { echo "not the package of $3"; return 1; }
    [ -z "${4:-}" ] || grep -q " of $4\$" "$work/$1.cmake.log" || { echo "not the OpenCV of $4"; return 1; }
    cmake --build "$work/$1" &&
    LD_LIBRARY_PATH="${5:-}" "$work/$1/usac_consumer"
}

install_opencv()
{
    for component in libs dev; do
        cmake --install "$opencv" --prefix "$work/opencv_staging" --component $component || return 1
    done
    mv "$work/opencv_staging" "$work/opencv"
}

by_pkg_config()
{
    flags=$(PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig" pkg-config --cflags --libs opencv_usac) &&
    c++ -std=c++11 "$here/main.cpp" $flags -o "$work/by_pkg_config" &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/by_pkg_config"
}

# The samples of components of one's own, against the installed library.
custom_components()
{
    flags=$(PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig" pkg-config --cflags --libs opencv_usac opencv4) &&
    c++ -std=c++11 "$project/samples/custom_sampler.cpp" $flags -o "$work/custom_sampler" &&
    c++ -std=c++11 "$project/samples/custom_quality.cpp" $flags -o "$work/custom_quality" &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/custom_sampler" --help &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/custom_quality" "$project/test_data/graf.txt"
}

# Each case of flags/cases.cpp.
flag_cases()
{
    cmake -S "$here/flags" -B "$work/flags" "-DCMAKE_PREFIX_PATH=$work/prefix"
}

flag_case() # name
{
    grep -q "flag case $1: as it should be" "$work/flag_cases.log" || { grep "flag case $1:" "$work/flag_cases.log"; false; }
}

mkdir -p "$work"
for directory in build staging prefix opencv_staging opencv by_prefix by_build in_tree_by_prefix in_tree_by_dir in_tree_by_build \
    by_pkg_config flags
do
    rm -rf "${work:?}/$directory"
done
check install install_library
check relocatable relocatable
check cmake consumer by_prefix "-DCMAKE_PREFIX_PATH=$work/prefix" "$work/prefix/lib/cmake/opencv_usac"
check cmake_build_tree consumer by_build "-DCMAKE_PREFIX_PATH=$work/build" "$work/build"
if [ -n "$opencv" ]; then
    check in_tree_install install_opencv
    libraries=$(echo "$work"/opencv/lib*)
    packages=$libraries/cmake
    check in_tree_prefix consumer in_tree_by_prefix "-DCMAKE_PREFIX_PATH=$work/opencv" "$packages/opencv_usac" \
        "$packages/opencv4" "$libraries"
    check in_tree_dir consumer in_tree_by_dir "-DOpenCV_DIR=$packages/opencv4" "$packages/opencv4" \
        "$packages/opencv4" "$libraries"
    check in_tree_build_tree consumer in_tree_by_build "-DOpenCV_DIR=$opencv" "$opencv" "$opencv"
fi
check pkg-config by_pkg_config
check custom_components custom_components
check flag_cases flag_cases
for name in $(sed -n 's/^#\(el\)*if defined(\([A-Z]*_[a-z_]*\))$/\2/p' "$here/flags/cases.cpp"); do
    check "$name" flag_case "$name"
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
