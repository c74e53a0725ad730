#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Builds the library and its samples against the installed OpenCV, installs them into a temporary prefix, moves that, and
# builds and runs the consumer project by the CMake package and by pkg-config, and looks whether programs that would lose a flag
# are refused by the compiler. The last line is "<N> passed, <M> failed".
# usage: check.sh [working directory]

here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../../.." && pwd)
work=${1:-${TMPDIR:-/tmp}/opencv_usac_consumer}
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

by_cmake()
{
    cmake -S "$here" -B "$work/by_cmake" "-DCMAKE_PREFIX_PATH=$work/prefix" &&
    cmake --build "$work/by_cmake" &&
    "$work/by_cmake/usac_consumer"
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
for directory in build staging prefix by_cmake by_pkg_config flags; do
    rm -rf "${work:?}/$directory"
done
check install install_library
check relocatable relocatable
check cmake by_cmake
check pkg-config by_pkg_config
check custom_components custom_components
check flag_cases flag_cases
for name in $(sed -n 's/^#\(el\)*if defined(\([A-Z]*_[a-z_]*\))$/\2/p' "$here/flags/cases.cpp"); do
    check "$name" flag_case "$name"
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
