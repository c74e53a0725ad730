#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Builds the library and its samples against the installed OpenCV, and installs them into a
# temporary prefix, which is then moved. Builds and runs the consumer project (main.cpp) with the
# CMake package and with pkg-config. Checks that the compiler rejects programs that would silently
# lose a flag. If a build of OpenCV with the module is given, the consumer project is also built and
# run against the build tree and against a moved installation of this OpenCV. Further checks: the
# library as C++20 inside another CMake project; the pages of the documentation; the Debian packages
# and their contents; the commands and code of README, the module's page, the tutorials,
# doc/contributing.md and doc/benchmark.md, which need the packages of common.sh. The last line is
# "<N> passed, <M> failed".
# usage: check.sh [working directory [build tree of OpenCV with the module]]
#        check.sh --build working directory [target...]      only builds the library
#
#   USAC_CONSUMER_OPTIONS  further CMake options for the build of the library in <working
#                          directory>/build
#   USAC_CONSUMER_QUICK    if not empty, projects that contain the library are only configured: this
#                          checks that they keep their build type, targets and package, but does not
#                          compile the library again

here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../../.." && pwd)
only_build=
[ "${1:-}" != --build ] || { only_build=1; shift; }
work=${1:-${TMPDIR:-/tmp}/opencv_usac_consumer}
opencv=${2:-}
installed=opencv$(pkg-config --exists opencv5 && echo 5 || echo 4)  # the system's OpenCV for pkg-config, and its header folder
[ "$installed" = opencv4 ] && oldest=c++11 || oldest=c++17  # oldest standard that OpenCV's headers support
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

# The build is configured from scratch each time; compiled files are kept.
build_library() # targets
{
    rm -f "$work/build/CMakeCache.txt" "$work"/build/*.deb
    PATH="$work/other_python:$PATH" cmake -S "$project" -B "$work/build" -DUSAC_WERROR=ON -DCMAKE_INSTALL_PREFIX=/usr \
        -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_PYTHON=ON -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON ${USAC_CONSUMER_OPTIONS:-} &&
    cmake --build "$work/build" -j "$(nproc)" --target "$@"
}

install_library()
{
    build_library all &&
    cmake --install "$work/build" --prefix "$work/uninstalled" &&
    cmake --build "$work/build" --target uninstall &&
    cmake --install "$work/build" --prefix "$work/staging" &&
    mv "$work/staging" "$work/prefix"
}

relocatable()
{
    [ -d "$work/prefix" ] && ! grep -rIF -e "$project" -e "$work" "$work/prefix"
}

# Builds and runs the consumer project, which is the same for all ways of using the module. CMake must
# find the requested package and, if one is given, the requested OpenCV. The libraries of a moved
# OpenCV need LD_LIBRARY_PATH to find each other.
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
    c++ -std=$oldest "$here/main.cpp" $flags -o "$work/by_pkg_config" &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/by_pkg_config"
}

# Compiles and runs samples with custom components against the installed library.
custom_components()
{
    flags=$(PKG_CONFIG_PATH="$work/prefix/lib/pkgconfig" pkg-config --cflags --libs opencv_usac $installed) &&
    c++ -std=$oldest "$project/samples/custom_sampler.cpp" $flags -o "$work/custom_sampler" &&
    c++ -std=$oldest "$project/samples/custom_quality.cpp" $flags -o "$work/custom_quality" &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/custom_sampler" --help &&
    LD_LIBRARY_PATH="$work/prefix/lib" "$work/custom_quality" "$project/test_data/graf.txt"
}

# Builds the pages of the documentation; warnings are errors. Citations must be resolved, and the
# pages must contain the tutorials' pictures, but no paths of the build and no broken links.
documentation()
{
    cmake --build "$work/build" --target usac_docs &&
    pages=$work/build/doc/html &&
    grep -q 'USACv20: robust essential' "$pages/citelist.html" &&
    for tutorial in "$project"/modules/usac/tutorials/*/; do
        title=$(basename "$tutorial")
        for picture in "$tutorial"images/*; do
            grep -F "src=\"$(basename "$picture")\"" "$pages/tutorial_usac_$title.html" || return 1
        done
    done &&
    ! grep -rlIF -e "$project" -e "$work" "$pages" &&
    /usr/bin/python3 "$here/links.py" "$pages"
}

# Compiles each case of flags/cases.cpp.
flag_cases()
{
    cmake -S "$here/flags" -B "$work/flags" "-DCMAKE_PREFIX_PATH=$work/prefix"
}

flag_case() # name
{
    grep -q "flag case $1: as it should be" "$work/flag_cases.log" || { grep "flag case $1:" "$work/flag_cases.log"; false; }
}

# Uninstalling must remove all installed files and the folders that belong to the library.
uninstalled()
{
    [ -d "$work/uninstalled" ] && ! find "$work/uninstalled" -type f -o -name '*usac*' | grep .
}

# Builds the library inside another CMake project, by add_subdirectory and by FetchContent, each
# configured from scratch. There is no build type, so nothing is optimized; the build checks for
# warnings of C++20 (GCC also warns about changes in C++23). The second project has the same options
# and reuses the library of the first project, so nothing is compiled twice.
parent() # name, option of CMake
{
    rm -rf "$work/parent/CMakeCache.txt" "$work/parent/prefix" "$work/parent/parent"
    rm -rf "$work/parent/_deps"  # FetchContent's own CMake project, possibly configured with another generator
    cmake -S "$here/parent" -B "$work/parent" "$2" -DUSAC_WERROR=ON -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON &&
    { [ -z "${USAC_CONSUMER_QUICK:-}" ] || return 0; } &&
    cmake --build "$work/parent" -j "$(nproc)" &&
    "$work/parent/parent" &&
    cmake --install "$work/parent" --prefix "$work/parent/prefix" &&
    [ "$(find "$work/parent/prefix" -type f)" = "$work/parent/prefix/bin/parent" ]
}

# Compiles the consumer program and a sample with a custom component, without linking.
standard() # name of a C++ standard, such as c++20
{
    for source in "$here/main.cpp" "$project/samples/custom_sampler.cpp"; do
        c++ "-std=$1" -fsyntax-only -Wall -Wextra -Wshadow -Werror -isystem "/usr/include/$installed" \
            -I"$project/modules/usac/include" "$source" || return 1
    done
}

# An object file compiled for AVX must export only its table of kernels: the linker might use any
# other exported inline function of the file instead of the version for all processors. Both the
# optimized build and the unoptimized build of the function parent() are checked.
instruction_sets()
{
    [ "$(uname -m)" = x86_64 ] || return 0
    objects=$(find "$work/build" "$work/parent" -name '*_avx*.cpp.o')
    [ "$(echo "$objects" | wc -l)" -ge 2 ] &&
    for object in $objects; do
        [ "$(nm -C --defined-only "$object" | grep -c ' T .*avx[0-9]*Kernels()$')" = 1 ] || return 1
        ! nm -C --defined-only "$object" | grep ' [TWVuBDR] ' | grep -v -e 'avx[0-9]*Kernels()$' -e DW.ref.__gxx_personality || return 1
    done
}

# Builds and unpacks the packages; each must contain its copyright file.
debian_packages()
{
    (cd "$work/build" && cpack -G DEB) &&
    for package in libopencv-usac0 libopencv-usac-dev python3-usacv20 usac-benchmark; do
        dpkg-deb -x "$work"/build/$package*.deb "$work/debian" || return 1
    done &&
    for package in "libopencv-usac${version%.*}" libopencv-usac-dev python3-usacv20 usac-benchmark; do
        cmp "$project/LICENSE" "$work/debian/usr/share/doc/$package/copyright" || return 1
    done
}

# The target `uninstall` must not use the lists of files that cpack writes, because these files have
# not been installed.
debian_uninstall()
{
    rm -f "$work/build/install_manifest.txt"
    ls "$work"/build/install_manifest_*.txt &&
    ! cmake --build "$work/build" --target uninstall > "$work/uninstall.log" 2>&1 &&
    tr -s ' \n' ' ' < "$work/uninstall.log" | grep 'nothing has been installed'  # CMake wraps its messages
}

# Prints the paths of the libraries and programs in the unpacked packages.
compiled()
{
    find "$work/debian" -type f \( -name '*.so' -o -name '*.so.*' -o -path '*/bin/usac_*' \)
}

debian_paths()
{
    [ "$(compiled | wc -l)" -gt 2 ] && ! grep -rF -e "$project" -e "$work" "$work/debian" &&
    strings "$work/debian/usr/lib/libopencv_usac.so.$version" | grep '^modules/usac/src/'
}

debian_stripped()
{
    [ "$(compiled | wc -l)" -gt 2 ] &&
    for file in $(compiled); do
        readelf -S "$file" | grep -F .dynsym || return 1
        ! readelf -S "$file" | grep -F .symtab || return 1
    done
}

debian_python()
{
    PYTHONPATH="$work/debian/usr/lib/python3/dist-packages" LD_LIBRARY_PATH="$work/debian/usr/lib" /usr/bin/python3 -c "
import importlib.metadata, numpy, usacv20
assert usacv20.__file__.startswith('$work/debian'), usacv20.__file__
assert usacv20.__version__ == importlib.metadata.version('usacv20') == '$version'
assert importlib.metadata.requires('usacv20') == ['numpy >= 1.20']
try:
    usacv20.findHomography(*2 * [numpy.eye(4, 2)], usacv20.USACV20, -1.0)
    raise AssertionError('a threshold of -1 is taken')
except usacv20.error as error:
    assert error.file.startswith('modules/usac/'), error.file
"
}

debian_benchmark()
{
    LD_LIBRARY_PATH="$work/debian/usr/lib" "$work/debian/usr/bin/usac_benchmark" --help
}

# Runs the commands and programs that the documents show and compares their output. The library is
# already built, and compiled files of a previous run are kept.
documents()
{
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$here/documents/documents.py" "$project" "$work" "$opencv"
}

documents_test()
{
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$here/documents/test_documents.py"
}

mkdir -p "$work"
for directory in staging prefix opencv_staging opencv by_prefix by_build in_tree_by_prefix in_tree_by_dir in_tree_by_build \
    by_pkg_config flags uninstalled debian other_python
do
    rm -rf "${work:?}/$directory"
done
mkdir "$work/other_python"  # imitates a python3 of pyenv or conda, which lacks the required packages and must not be called
printf '#!/bin/sh\necho "another python3 was called" >&2\nexit 1\n' > "$work/other_python/python3"
cp "$work/other_python/python3" "$work/other_python/python"
chmod +x "$work/other_python/python3" "$work/other_python/python"
if [ -n "$only_build" ]; then
    shift
    build_library all "$@"
    exit
fi
check install install_library
check uninstalled uninstalled
check relocatable relocatable
check cmake consumer by_prefix "-DCMAKE_PREFIX_PATH=$work/prefix" "$work/prefix/lib/cmake/opencv_usac"
check cmake_build_tree consumer by_build "-DCMAKE_PREFIX_PATH=$work/build" "$work/build"
if [ -n "$opencv" ]; then
    check in_tree_install install_opencv
    libraries=$(echo "$work"/opencv/lib*)
    packages=$libraries/cmake
    package=$(echo "$packages"/opencv[0-9])
    check in_tree_prefix consumer in_tree_by_prefix "-DCMAKE_PREFIX_PATH=$work/opencv" "$packages/opencv_usac" \
        "$package" "$libraries"
    check in_tree_dir consumer in_tree_by_dir "-DOpenCV_DIR=$package" "$package" \
        "$package" "$libraries"
    check in_tree_build_tree consumer in_tree_by_build "-DOpenCV_DIR=$opencv" "$opencv" "$opencv"
fi
check pkg-config by_pkg_config
check custom_components custom_components
check parent parent parent -DFETCH=OFF
check fetch parent fetch -DFETCH=ON
check instruction_sets instruction_sets
check cxx20 standard c++20
check cxx23 standard c++2b
check documentation documentation
check debian_packages debian_packages
check debian_uninstall debian_uninstall
check debian_paths debian_paths
check debian_stripped debian_stripped
check debian_python debian_python
check debian_benchmark debian_benchmark
check documents_test documents_test
check documents documents
check flag_cases flag_cases
for name in $(sed -n 's/^#\(el\)*if defined(\([A-Z]*_[a-z_]*\))$/\2/p' "$here/flags/cases.cpp"); do
    check "$name" flag_case "$name"
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
