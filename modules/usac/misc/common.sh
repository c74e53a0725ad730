# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Functions and variables that run_tests.sh, sanitize.sh and matrix.sh share: they install packages,
# fetch and configure OpenCV's source, and count tests.

project=$(cd "$(dirname "$0")/../../.." && pwd)
module=$project/modules/usac
work=${USAC_BUILD_DIR:-${TMPDIR:-/tmp}/opencv_usac}
# On Debian 11 and 12, the source is OpenCV 4.10 of the suite trixie, the newest OpenCV 4 in Debian.
# On other systems, it is the system's own source package.
case $(. /etc/os-release && echo "${ID:-}-${VERSION_ID:-}") in debian-11 | debian-12) default_suite=trixie ;; *) default_suite= ;; esac
suite=${OPENCV_SUITE:-$default_suite}
source=${OPENCV_SOURCE_DIR:-$work/opencv${suite:+-$suite}}
build=$work/build-$(printf %s "$source" | cksum | cut -d ' ' -f 1)
packages="g++ cmake ninja-build ccache pkg-config xz-utils python3-dev python3-numpy libjpeg-dev libpng-dev zlib1g-dev
    libblas-dev liblapack-dev liblapacke-dev libeigen3-dev libopencv-dev pybind11-dev python3-opencv python3-build python3-pip
    python3-venv python3-setuptools python3-wheel mypy colmap python3-distributed python3-h5py python3-matplotlib python3-tqdm
    binutils dpkg-dev file doxygen texlive-binaries"
mkdir -p "$work"
export CMAKE_GENERATOR=Ninja CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_SLOPPINESS=pch_defines,time_macros  # without it, ccache does not store results with precompiled headers

passed=0 failed=1  # an exit before the first test counts as a failure
failures=  # lines of the logs that name the failed tests
trap '[ -z "$failures" ] || echo "$failures"; echo "$passed passed, $failed failed"' EXIT

as_root()
{
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() # further packages
{
    missing=
    for p in $packages "$@"; do
        dpkg-query -W -f '${db:Status-Status}\n' "$p" 2>/dev/null | grep -q '^installed' || missing="$missing $p"
    done
    [ -n "$missing" ] || return 0
    as_root apt-get update
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
}

# Fetches OpenCV's source package from the repository that provides libopencv-dev. If $suite is not
# empty, this suite of the repository is used. The settings of the system are not changed, and its
# package lists are updated only if they lack libopencv-dev.
fetch_opencv()
{
    apt=$work/apt
    mkdir -p "$apt/lists/partial" "$apt/archives/partial"
    keys=/usr/share/keyrings/debian-archive-keyring.gpg
    [ -f $keys ] && signed="[signed-by=$keys]" || signed=
    offers() { apt-cache policy libopencv-dev | awk '$NF == "Packages" { print $2, $3 }'; }
    [ -n "$(offers)" ] || as_root apt-get update
    offers | sort -u | sed "s|^|deb-src $signed |; s|/\([^/]*\)\$| \1|" > "$apt/sources.list"
    if [ -n "$suite" ]; then
        sed -i "1!d; s|[^ ]* \([^ ]*\)\$|$suite \1|" "$apt/sources.list"
    fi

    options="-o Dir::Etc::SourceList=$apt/sources.list -o Dir::Etc::SourceParts=/dev/null -o APT::Sandbox::User=root
        -o Dir::State::Lists=$apt/lists -o Dir::Cache=$apt"
    apt-get $options update
    # Only the archive of OpenCV itself; the contrib modules are not needed.
    set -- $(apt-get $options source --print-uris opencv | grep '/opencv_[^/]*\.orig\.tar\.')
    uri=$(echo "$1" | tr -d "'")
    /usr/lib/apt/apt-helper $options download-file "$uri" "$work/$2" "$4"
    rm -rf "$source.part"
    mkdir "$source.part"
    tar -xf "$work/$2" -C "$source.part" --strip-components=1
    mv "$source.part" "$source"
    rm "$work/$2"
}

# Configures OpenCV with the module. OpenCV 4.6 does not find Debian's cblas.h by itself, so the LAPACK
# libraries are named. The module is compiled as in a release. OpenCV and the tests are compiled with
# little optimization and for one instruction set, which halves the build time; their speed is not
# tested.
configure()
{
    cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DUSAC_SOURCE_FLAGS=-O3 \
        -DCMAKE_C_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCPU_DISPATCH= \
        -DOPENCV_EXTRA_MODULES_PATH="$project/modules" -DUSAC_WERROR=ON -DPYTHON3_EXECUTABLE=/usr/bin/python3 \
        -DBUILD_LIST=usac,ts,python3 -DBUILD_TESTS=ON -DBUILD_PERF_TESTS=ON -DBUILD_opencv_apps=OFF -DBUILD_JAVA=OFF \
        -DLAPACK_LIBRARIES="lapack;blas" -DLAPACK_CBLAS_H=cblas.h -DLAPACK_LAPACKE_H=lapacke.h -DLAPACK_IMPL=Debian \
        -DWITH_GTK=OFF -DWITH_QT=OFF -DWITH_FFMPEG=OFF -DWITH_GSTREAMER=OFF -DWITH_V4L=OFF -DWITH_1394=OFF \
        -DWITH_OPENCL=OFF -DWITH_ADE=OFF -DWITH_IPP=OFF -DWITH_ITT=OFF -DWITH_PROTOBUF=OFF -DWITH_QUIRC=OFF \
        -DWITH_OPENEXR=OFF -DWITH_JASPER=OFF -DWITH_OPENJPEG=OFF -DWITH_WEBP=OFF -DWITH_TIFF=OFF
}

# Prints the processor time in seconds of the step that has just ended.
processor_seconds()
{
    cat "$work/$name.before" "$work/$name.after" | tr 'ms' '  ' |
        awk '{ t[NR] = 60 * ($1 + $3) + $2 + $4 } END { printf "%d", t[4] - t[2] }'
}

# Runs a command, shows its output, and adds the numbers of passed and failed tests that the
# patterns find in the output. A command that reports no failed test, but fails or reports no passed
# test, counts as one failed test.
run() # name, pattern of passed, pattern of failed, command
{
    name=$1 p=$2 f=$3
    shift 3
    echo "== $name"
    from=$(date +%s)
    times > "$work/$name.before"
    { "$@" && rc=0 || rc=$?; echo $rc > "$work/rc"; } 2>&1 | tee "$work/$name.log"
    p=$(sed -n "s/$p/\1/p" "$work/$name.log" | tail -n 1)
    f=$(sed -n "s/$f/\1/p" "$work/$name.log" | tail -n 1)
    p=${p:-0} f=${f:-0}
    if [ "$f" = 0 ] && { [ "$(cat "$work/rc")" != 0 ] || [ "$p" = 0 ]; }; then f=1; fi
    [ "$f" = 0 ] || failures="$failures
$name: $(grep -E "^(FAILED|FAIL:|ERROR:|\[  FAILED  \]|on the list, but )" "$work/$name.log" | sort -u | head -n 20)"
    passed=$((passed + p)) failed=$((failed + f))
    times > "$work/$name.after"
    echo "== $name: $p passed, $f failed, $(($(date +%s) - from)) s, $(processor_seconds) s of processor time"
}

# Runs a GoogleTest program in as many processes as there are processors; the processes share its
# tests.
in_shards() # program
{
    shards=$(nproc) shard=0 processes=
    while [ $shard -lt "$shards" ]; do
        GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard "$@" > "$work/shard.$shard.log" 2>&1 &
        processes="$processes $!" shard=$((shard + 1))
    done
    rc=0
    for process in $processes; do wait "$process" || rc=1; done
    cat "$work"/shard.*.log
    p=$(cat "$work"/shard.*.log | sed -n "s/$gtest_passed/\1/p" | awk '{ n += $1 } END { print n + 0 }')
    f=$(cat "$work"/shard.*.log | sed -n "s/$gtest_failed/\1/p" | awk '{ n += $1 } END { print n + 0 }')
    rm "$work"/shard.*.log
    echo "$p passed, $f failed"
    return $rc
}

# A program for python3 -c that runs all unit tests in the files of the current folder that match a
# pattern, its first argument.
run_unittests='
import sys, unittest
tests = unittest.defaultTestLoader.discover(".", sys.argv[1])
result = unittest.TextTestRunner(verbosity=2).run(tests)
bad = len(result.failures) + len(result.errors) + len(result.unexpectedSuccesses)
print("%d passed, %d failed" % (max(result.testsRun - len(result.skipped) - bad, 0), bad))
sys.exit(bad)'

# Tests that are not run with slow builds (sanitizers, assertions, coverage, Debug, emulation). They
# measure a frequency over many seeds, or time and memory of many calls, and other tests reach the
# same code. Each takes 20 seconds to 5 minutes with -O0.
slow_tests='Usac_Scale.*:UsacScale.work_is_linear*:Usac_Confidence.*:Usac_Degensac.dominantPlanes:Usac_Degensac.generalScenes*'
slow_tests=$slow_tests:Usac_Hostile.most_points_of_one_image_on_a_line:Usac_StopLate.*

# Further tests that measure frequencies or means over many scenes. They are not run with sanitizers
# and assertions, because other tests reach the same code, and not by an emulator, which is about 30
# times slower: the stored hashes show that the results are the same as on other processors.
statistics='Usac_Significance.*:Usac_Agreeing.*:Usac_ConfirmedOrder.badScoresAreSeen:Usac_Leverage.small_baselines'
statistics=$statistics:Usac_PlaneParallax.fewSearchFailures:Usac_Alternatives.scores_of_another_motion_do_not_mislead
statistics=$statistics:Usac_PointCovariances.accuracy*:Usac_PointCovariances.significance*:Usac_RepeatedStructure.*
statistics=$statistics:Usac_WidestReach.*:Usac_TwoViewBatch.cancelled_at_any_time:Usac_Maps.inlierRatios*

gtest_passed='^\[  PASSED  \] \([0-9]*\) test.*'
gtest_failed='^\[  FAILED  \] \([0-9]*\) test.*listed below.*'
count_passed='^\([0-9]*\) passed, .*'
count_failed='^.* passed, \([0-9]*\) failed$'
