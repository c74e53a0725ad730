#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Runs the tests with other systems, compilers, options and processors. The last lines are a table
# and "<N> passed, <M> failed".
#
# usage: matrix.sh [row...]          default: all rows, one after the other
#
#   bookworm trixie sid    run_tests.sh --installed with a complete consumer check, on Debian 12
#                          (OpenCV 4.6, g++ 12), 13 (4.10, g++ 14) and the newest Debian (sid) with
#                          OpenCV 5 from experimental. Each row runs in a root file system made by
#                          debootstrap, which is kept, or directly if this system has that version
#   clang cxx17 cxx20 static debug    run_tests.sh --cpp on this system: compiled by clang++, with
#                                     another C++ standard, as a static library with the samples, or
#                                     as Debug with -Og (without slow_tests of common.sh). Rows other
#                                     than cxx17 and cxx20 use C++11, except sid (C++17)
#   arm64                  run_tests.sh --cpp for 64-bit ARM, with bookworm's packages:
#                          cross-compiled, run by qemu, without slow_tests and statistics of common.sh
#   mingw                  the library's sources are compiled for Windows by mingw-w64, with the
#                          headers of this system's OpenCV; each file counts as a test
#
# clang uses libstdc++, because Debian's OpenCV uses it and a program can have only one C++ library.
# Creating the root file systems needs root.
#
#   USAC_MATRIX_DIR     folder for root file systems and results; default
#                       ${TMPDIR:-/tmp}/opencv_usac_matrix
#   USAC_MATRIX_MIRROR  Debian mirror; default http://deb.debian.org/debian

set -eu
. "$(dirname "$0")/common.sh"
trap - EXIT
roots=${USAC_MATRIX_DIR:-${TMPDIR:-/tmp}/opencv_usac_matrix}
mirror=${USAC_MATRIX_MIRROR:-http://deb.debian.org/debian}
all="bookworm trixie sid clang cxx17 cxx20 static debug arm64 mingw"
mounted=
ccache=$(ccache --get-config cache_dir 2> /dev/null || echo "$HOME/.cache/ccache")

unmount()
{
    for folder in $mounted; do umount "$folder" || umount -l "$folder"; done
    mounted=
}

# Mounts a folder at the same path inside a root file system.
mount_into() # root, folder
{
    mkdir -p "$1$2"
    mountpoint -q "$1$2" && return
    mount --bind "$2" "$1$2"
    mounted="$1$2 $mounted"
}

# Makes a root file system with the packages that this script needs; run_tests.sh installs the
# packages that the tests need.
make_root() # suite
{
    root=$roots/$1
    if [ ! -f "$root/.complete" ] && [ ! -d "$root/usr/include/opencv5" ]; then
        command -v debootstrap > /dev/null || as_root apt-get install -y debootstrap
        rm -rf "$root.part"
        debootstrap --variant=minbase "$1" "$root.part" "$mirror"
        echo 'Acquire::Check-Valid-Until "false";' > "$root.part/etc/apt/apt.conf.d/90matrix"
        if [ "$1" = sid ]; then echo "deb $mirror experimental main" >> "$root.part/etc/apt/sources.list"; fi
        mv "$root.part" "$root"
        touch "$root/.complete"
    fi
    mountpoint -q "$root/proc" || { mount -t proc proc "$root/proc"; mounted="$root/proc $mounted"; }
    mountpoint -q "$root/dev" || { mount --bind /dev "$root/dev"; mounted="$root/dev $mounted"; }
    mkdir -p "$ccache"
    mount_into "$root" "$project"
    mount_into "$root" "$ccache"
    if [ "$1" = sid ] && [ ! -d "$root/usr/include/opencv5" ]; then
        chroot "$root" sh -ec 'apt-get update
            DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends -t experimental libopencv-dev python3-opencv'
    fi
}

# Prints the versions of OpenCV and of g++.
versions() # command that runs its arguments, such as env, or chroot with a folder
{
    echo "$("$@" sh -c 'pkg-config --modversion opencv5 2> /dev/null || pkg-config --modversion opencv4'), g++ $("$@" g++ -dumpfullversion)"
}

run_suite() # suite
{
    rc=0
    if [ "$1" = "$(. /etc/os-release && echo "${VERSION_CODENAME:-}")" ]; then
        USAC_CONSUMER_QUICK= USAC_BUILD_DIR="$roots/system" sh "$module/misc/run_tests.sh" --installed || rc=$?
        versions env > "$roots/$row.versions"
        return $rc
    fi
    make_root "$1"
    chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CCACHE_DIR="$ccache" DEBIAN_FRONTEND=noninteractive \
        USAC_CONSUMER_QUICK= USAC_BUILD_DIR=/var/tmp/opencv_usac sh "$module/misc/run_tests.sh" --installed || rc=$?
    versions chroot "$root" > "$roots/$row.versions"
    return $rc
}

run_cpp() # version of the compiler, options for CMake
{
    echo "$(versions env | sed "s/, .*//"), $1" > "$roots/$row.versions"
    shift
    USAC_BUILD_DIR="$roots/system" USAC_CPP_OPTIONS="$*" sh "$module/misc/run_tests.sh" --cpp
}

# Unpacks Debian's arm64 packages that the tests are linked with, without running any of their
# programs. OpenCV modules that the tests do not use are included, because OpenCV's CMake package
# requires their libraries; the packages on which these modules depend are not included.
make_arm64()
{
    root=$roots/arm64
    [ ! -f "$root/.complete" ] || return 0
    apt=$roots/arm64-apt
    rm -rf "$root" "$apt"
    mkdir -p "$apt/lists/partial" "$apt/archives/partial" "$root/usr/lib" "$root/usr/bin"
    ln -s usr/lib "$root/lib"
    touch "$apt/status"
    keys=/usr/share/keyrings/debian-archive-keyring.gpg
    [ -f $keys ] && signed="[signed-by=$keys]" || signed=
    echo "deb $signed $mirror bookworm main" > "$apt/sources.list"
    arm="-o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State=$apt -o Dir::State::Lists=$apt/lists -o Dir::State::status=$apt/status
        -o Dir::Cache=$apt -o Dir::Etc::SourceList=$apt/sources.list -o Dir::Etc::SourceParts=/dev/null -o APT::Sandbox::User=root"
    apt-get $arm update
    apt-get $arm install -y --no-install-recommends --download-only libopencv-calib3d-dev libgtest-dev libeigen3-dev
    for dev in $(apt-cache $arm depends libopencv-dev | sed -n 's/^ *Depends: \(libopencv-.*-dev\)$/\1/p'); do
        echo $dev $(apt-cache $arm depends $dev | sed -n 's/^ *Depends: \(libopencv-.*[0-9]\)$/\1/p')
    done | tr ' ' '\n' | sort -u > "$apt/modules"
    (cd "$apt/archives" && apt-get $arm download libopencv-dev $(cat "$apt/modules"))
    for package in "$apt"/archives/*.deb; do dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C "$root"; done
    [ -L "$root/lib" ]
    touch "$root/.complete"
}

run_arm64()
{
    install_packages g++-aarch64-linux-gnu qemu-user-static
    make_arm64
    libraries=usr/lib/aarch64-linux-gnu
    opencv=$(sed -n 's/^Version: //p' "$root/$libraries/pkgconfig/opencv4.pc")
    echo "$opencv, g++ $(aarch64-linux-gnu-g++ -dumpfullversion), aarch64" > "$roots/$row.versions"
    cat > "$roots/arm64.cmake" <<END
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH "$root")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-rpath-link,$root/$libraries:$root/$libraries/blas:$root/$libraries/lapack")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "\${CMAKE_EXE_LINKER_FLAGS_INIT}")
END
    USAC_BUILD_DIR="$roots/system" USAC_CPP_OPTIONS="-DCMAKE_TOOLCHAIN_FILE=$roots/arm64.cmake -DOpenCV_DIR=$root/$libraries/cmake/opencv4" \
        USAC_CPP_RUNNER="qemu-aarch64-static -L $root -E LD_LIBRARY_PATH=$root/$libraries:$root/$libraries/blas:$root/$libraries/lapack" \
        USAC_CPP_FILTER="-$slow_tests:$statistics" sh "$module/misc/run_tests.sh" --cpp
}

# The module must compile without POSIX functions (threads, files, memory). Nothing is linked,
# because there is no OpenCV for Windows.
run_mingw()
{
    install_packages g++-mingw-w64-x86-64-posix
    compiler=x86_64-w64-mingw32-g++-posix good=0 bad=0
    echo "$(versions env | sed "s/, .*//"), g++ $($compiler -dumpversion), Windows" > "$roots/$row.versions"
    mkdir -p "$roots/mingw"  # with /usr/include, the compiler would also find the headers of this system's C library
    ln -sfn /usr/include/opencv4/opencv2 "$roots/mingw/opencv2"
    for file in $(cd "$module" && find src -name '*.cpp' | sort); do
        case $file in *_avx2.cpp) set="-mavx2" ;; *_avx512.cpp) set="-mavx512f -mavx512bw -mavx512dq -mavx512vl" ;; *) set= ;; esac
        if $compiler -c -o "$roots/mingw/object.o" -std=c++11 -Wall -Wextra -Wshadow -Werror -D_USE_MATH_DEFINES -DCVAPI_EXPORTS \
            -DUSACV20_HAVE_AVX2 -DUSACV20_HAVE_AVX512 -fno-math-errno -fno-trapping-math -ffp-contract=off -fopenmp-simd $set -I"$module/include" \
            -I"$module/src" -isystem "$roots/mingw" -isystem /usr/include/eigen3 "$module/$file"
        then good=$((good + 1)); else bad=$((bad + 1)); echo "FAILED $file"; fi
    done
    echo "$good passed, $bad failed"
    [ $bad = 0 ]
}

run_row()
{
    case $1 in
    bookworm | trixie | sid) run_suite "$1" ;;
    clang) install_packages clang && run_cpp "clang $(clang++ -dumpversion)" -DCMAKE_CXX_COMPILER=clang++ ;;
    cxx17 | cxx20) run_cpp "g++ $(g++ -dumpfullversion), C++${1#cxx}" "-DCMAKE_CXX_STANDARD=${1#cxx}" ;;
    static) run_cpp "g++ $(g++ -dumpfullversion), static" -DBUILD_SHARED_LIBS=OFF -DBUILD_SAMPLES=ON ;;
    debug) USAC_CPP_FILTER="-$slow_tests" run_cpp "g++ $(g++ -dumpfullversion), Debug" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-Og ;;
    arm64 | mingw) "run_$1" ;;
    esac
}

[ $# -gt 0 ] || set -- $all
for row in "$@"; do
    case " $all " in *" $row "*) ;; *) echo "usage: matrix.sh [row...], of: $all" >&2; exit 2 ;; esac
done
mkdir -p "$roots"
table=$roots/table.txt
passed=0 failed=0
printf '| %-8s | %-32s | %6s | %6s | %7s |\n' row "OpenCV, compiler" passed failed seconds > "$table"
printf '|---|---|---:|---:|---:|\n' >> "$table"
for row in "$@"; do
    echo "==== $row"
    rm -f "$roots/$row.versions"
    echo 1 > "$roots/$row.rc"
    from=$(date +%s)
    # `set -e` applies inside the subshell: a failed step ends the row, but not the script
    set +e
    (set -e; trap unmount EXIT; trap 'exit 1' INT TERM; run_row "$row"; echo 0 > "$roots/$row.rc") 2>&1 | tee "$roots/$row.log"
    set -e
    p=$(sed -n "s/$count_passed/\1/p" "$roots/$row.log" | tail -n 1)
    f=$(sed -n "s/$count_failed/\1/p" "$roots/$row.log" | tail -n 1)
    if [ -z "$f" ] || { [ "$f" = 0 ] && [ "$(cat "$roots/$row.rc")" != 0 ]; }; then f=1; fi
    passed=$((passed + ${p:-0})) failed=$((failed + f))
    printf '| %-8s | %-32s | %6s | %6s | %7s |\n' "$row" "$(cat "$roots/$row.versions" 2> /dev/null)" "${p:-0}" "$f" $(($(date +%s) - from)) >> "$table"
done
cat "$table"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
