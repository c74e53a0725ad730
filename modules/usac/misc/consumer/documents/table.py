# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The table of rules, in the order in which the blocks run. Each rule is (document, heading, block,
action). The name of a block is its language and its number below the heading."""

import os
import shutil
import subprocess

from actions import CMake, Cpp, Python, Shell, Skipped

README, MODULE, CONTRIBUTING, BENCHMARK = "README.md", "modules/usac/README.md", "doc/contributing.md", "doc/benchmark.md"
FLAGS = "modules/usac/tutorials/ransac_to_usacv20/ransac_to_usacv20.markdown"
COLLECTIONS = "modules/usac/tutorials/collections/collections.markdown"
THRESHOLD = "modules/usac/tutorials/threshold/threshold.markdown"
COVARIANCE = "modules/usac/tutorials/covariance/covariance.markdown"
DOCUMENTS = (README, MODULE, "modules/usac/tutorials/usac.markdown", FLAGS, THRESHOLD, COVARIANCE, COLLECTIONS, CONTRIBUTING, BENCHMARK)

ENV = ("{work}/clone/env/bin",)
# In quick mode the package is linked with the existing library, which is not compiled again.
LINKED = " -Dopencv_usac_DIR={build}" if os.environ.get("USAC_CONSUMER_QUICK") else ""
QUICKSTART = """mkdir -p "{work}/quickstart"
ln -sfn "{build}" "{work}/quickstart/build-$(printf %s "$PWD" | cksum | cut -d ' ' -f 1)"
rm -f "{checks}/readme_build/CMakeCache.txt\""""
VENV = """rm -f "{checks}/readme_build/CMakeCache.txt\""""
NATIVE = {"USACV20_BUILD_DIR": "{checks}/readme_build"}  # compiled files are kept for the next run
LISTS = """for scene in planar general view rigid; do
    usac_synthetic --out=DATA --scene=$scene --pairs=1 --size=200 --inliers=0.6 --scores=0.8 > /dev/null
done
usac_synthetic --out=DATA --scene=planar --name=homogr --pairs=1 --size=200 --inliers=0.6 --scores=0.8 > /dev/null
usac_synthetic --out=DATA --scene=view --name=pnp --pairs=1 --size=200 --inliers=0.6 > /dev/null
ln -sfn DATA DIR"""
FIRST_LIST = """usac_synthetic --out=DATA --scene=planar --name=homogr --pairs=1 --size=200 --inliers=0.6 > /dev/null
ln -s ../clone/modules ."""
FEW = {"--pairs=25": "--pairs=1"}  # fewer pairs than in the text, to save time
FILES = "import sys; sys.path.insert(0, '../clone/modules/usac/benchmark')\n"
RUNS = "usac_benchmark --list=DATA/lists/homogr.H.list --runs=runs.csv --methods=USACV20,cv:USAC_DEFAULT,cv:RANSAC > /dev/null"
PREFIX = {"<prefix>": "{work}/prefix"}
POSES = "const std::vector<cv::Point3f> nextObjectPoints = objectPoints; const std::vector<cv::Point2f> nextImagePoints = imagePoints;"
PARAMS = "cv::usacv20::Params params; params.threshold = 1;"
MASK = "cv::Mat mask;"
REPORT = "cv::usacv20::Report report;"
NOISE = """cv::RNG rng(2);
for (cv::Point2f& point : points2)
    point += cv::Point2f((float)rng.gaussian(0.3), (float)rng.gaussian(0.3));
"""
WITH_COVARIANCE = NOISE + PARAMS + " params.covariance = 1;"
NOISE_PYTHON = """import usacv20
points2 = points2 + np.random.RandomState(2).normal(0, 0.3, points2.shape)
params = usacv20.Params(covariance=1, threshold=1)"""
FOUND = """
cv::Mat mask; cv::usacv20::Report report;
const cv::Mat H = cv::usacv20::estimateHomography(points1, points2, params, mask, report);"""
SCORES_OF_HLOC = """python3 -c "
import sqlite3, h5py, numpy as np
db = sqlite3.connect('scene.db')
names, sizes = dict(db.execute('SELECT image_id, name FROM images')), dict(db.execute('SELECT image_id, rows FROM keypoints'))
with h5py.File('matches.h5', 'w') as file:
    for pair, rows, data in db.execute('SELECT pair_id, rows, data FROM matches'):
        if rows:
            first, second = sorted(((pair - pair % 2147483647) // 2147483647, pair % 2147483647))
            a, b = np.frombuffer(data, np.uint32).reshape(-1, 2).T
            partners, scores = np.full(sizes[first], -1, np.int32), np.zeros(sizes[first], np.float16)
            partners[a], scores[a] = b, 0.5
            group = file.create_group(names[first] + '/' + names[second])
            group['matches0'], group['matching_scores0'] = partners, scores
" """
# The commands in the document have the option names of COLMAP 3. With COLMAP 4, these names are replaced, as the
# document explains.
OPTIONS_OF_COLMAP = {"--SiftExtraction.use_gpu": "--FeatureExtraction.use_gpu", "--SiftMatching.use_gpu": "--FeatureMatching.use_gpu"}
if not shutil.which("colmap") or b"FeatureExtraction.use_gpu" not in subprocess.run(
        ["colmap", "feature_extractor", "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False).stdout:
    OPTIONS_OF_COLMAP = {}  # COLMAP is missing or of version 3, so nothing is replaced

TABLE = [
    # Blocks of README. Most commands run in a scratch checkout (Place), whose folder build is a link to
    # the build that check.sh has made.
    (README, "Two commands", "sh 1", Shell(
        before=QUICKSTART, variables=dict(NATIVE, USAC_BUILD_DIR="{work}/quickstart", CMAKE_ARGS="-DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON" + LINKED),
        without=("sh modules/usac/misc/run_tests.sh --installed",))),
    (README, "Building", "sh 1", Shell(names=PREFIX)),
    (README, "Building", "cmake 1", CMake(("-DCMAKE_PREFIX_PATH={work}/prefix",))),
    (README, "Python", "sh 1", Shell(before=VENV, path=("{checks}/other_python",),
                                     variables=dict(NATIVE, CMAKE_ARGS="-Dopencv_usac_DIR={build} -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON"))),
    (README, "In a program", "python 1", Python()),
    (README, "In a program", "cpp 1", Cpp(
        before="cv::Mat rvec, tvec;",
        within={"std::vector<cv::Point2f> points1, points2;": "points1 = ::points1; points2 = ::points2;",
                "std::vector<std::vector<cv::Point2f>> lists1, lists2;": "lists1.assign(2, points1); lists2.assign(2, points2);"})),
    (README, "Measured", "sh 1", Skipped("a check of the benchmark's tests")),
    (MODULE, "Building", "sh 1", Skipped("run_tests.sh builds the module inside of OpenCV")),
    (MODULE, "Building", "sh 2", Shell(names=PREFIX, without=("cmake --build build --target usac_docs",))),
    (MODULE, "Building", "cmake 1", CMake(("-DCMAKE_PREFIX_PATH={checks}/prefix",))),
    (MODULE, "Building", "cmake 2", CMake(links={"opencv_usac": "{project}"}, build=False)),  # the checks `parent` and `fetch` compile it
    (MODULE, "Building", "sh 3", Shell(before="rm -f build/*.deb", always="cmake -S . -B build -DBUILD_SAMPLES=ON")),
    (MODULE, "Components of your own", "cpp 1", Cpp(before=PARAMS, top='#include "spread_sampler.hpp"', folders=("samples",))),

    (FLAGS, "A flag", "cpp 1", Cpp()),
    (FLAGS, "A flag", "cpp 2", Cpp(
        before=MASK + """ const bool quick = false;
{ cv::FileStorage out("settings.yml", cv::FileStorage::WRITE); out << "method" << 16385; }""")),
    (FLAGS, "A flag", "python 1", Python(cv2=True)),
    (FLAGS, "Options, scores and a report", "cpp 1", Cpp()),
    (FLAGS, "Options, scores and a report", "python 1", Python(cv2=True, before="import cv2")),
    (FLAGS, "Options, scores and a report", "cpp 2", Cpp()),
    (THRESHOLD, "A flag", "cpp 1", Cpp()),
    (THRESHOLD, "A flag", "cpp 2", Cpp(before=MASK)),
    (THRESHOLD, "A flag", "python 1", Python(before="import usacv20")),
    (THRESHOLD, "Matches of different noise", "python 1", Python(
        before="import usacv20\nsizes1, sizes2 = np.random.RandomState(1).uniform(2, 6, (2, len(points1)))")),
    (THRESHOLD, "Matches of different noise", "python 2", Python(
        before="import usacv20\nangles = np.random.RandomState(1).uniform(0, np.pi, len(points1))")),
    (COVARIANCE, "Requesting the covariance", "cpp 1", Cpp(before=NOISE)),
    (COVARIANCE, "Requesting the covariance", "python 1", Python(before=NOISE_PYTHON)),
    (COVARIANCE, "A corner", "cpp 1", Cpp(before=WITH_COVARIANCE + FOUND)),
    (COVARIANCE, "A corner", "python 1", Python(before=NOISE_PYTHON + """
H, mask, report = usacv20.estimateHomography(points1, points2, params)""")),
    (COVARIANCE, "A motion", "cpp 1", Cpp(before=WITH_COVARIANCE)),
    (COVARIANCE, "A motion", "python 1", Python(before=NOISE_PYTHON)),
    (FLAGS, "To stop a run", "cpp 1", Cpp(before=MASK + " const auto show = [](int, int) {};")),
    (FLAGS, "To stop a run", "python 1", Python(before="import threading, usacv20")),
    (FLAGS, "What comes next", "python 1", Python(cv2=True, before="""
import cv2
H, mask, report = cv2.usacv20.estimateHomography(points1, points2, cv2.usacv20.Params(threshold=1.0))
within = np.ravel(mask) == 1
quality = within.astype(float)""")),
    (FLAGS, "What comes next", "python 2", Python(cv2=True, before="import cv2")),
    (FLAGS, "What comes next", "cpp 1", Cpp(before="const cv::Mat K1 = K, K2 = K, d1, d2; cv::Mat R, t, mask;")),
    (FLAGS, "What comes next", "cpp 2", Cpp(before="cv::usacv20::Params params; cv::Mat mask;")),
    (FLAGS, "What comes next", "cpp 3", Cpp(
        before="const cv::usacv20::Params params;",
        within={"std::vector<std::vector<cv::Point2f>> lists1, lists2;": "lists1.assign(3, points1); lists2.assign(3, points2);"})),
    (FLAGS, "What comes next", "python 3", Python(cv2=True, before="import cv2\nlistOfParams = [cv2.usacv20.Params()] * 2")),
    (FLAGS, "A component of your own", "cpp 1", Cpp(before=PARAMS + REPORT)),
    (FLAGS, "An initial model", "cpp 1", Cpp(before=PARAMS + MASK + REPORT + POSES)),
    (FLAGS, "An initial model", "python 1", Python(before="import usacv20\nparams, pose = usacv20.Params(), np.eye(3, 4)")),
    (FLAGS, "Another model", "cpp 1", Cpp(before="using namespace cv;" + PARAMS, top='#include "affine_problem.hpp"', folders=("samples",))),
    (FLAGS, "Another model", "cpp 2", Cpp(before="using namespace cv;" + PARAMS + MASK + """
const std::vector<Point2f> nextPoints1 = points1, nextPoints2 = points2;
const Ptr<usacv20::Usac> usac = usacv20::Usac::create(cv::usacv20::HOMOGRAPHY, std::vector<Point2f>(50), std::vector<Point2f>(50), params);""")),

    # Blocks of the tutorial on collections, on a folder of five synthetic images.
    (COLLECTIONS, "Features and matches", "sh 1", Shell(
        "collection", names=OPTIONS_OF_COLMAP, before="/usr/bin/python3 {project}/modules/usac/misc/consumer/documents/images.py images")),
    (COLLECTIONS, "Verification", "sh 1", Shell("collection", path=ENV)),
    (COLLECTIONS, "Reconstruction", "sh 1", Shell("collection")),
    (COLLECTIONS, "New images and other programs", "python 1", Python(where="collection")),
    (COLLECTIONS, "New images and other programs", "python 2", Python()),
    (COLLECTIONS, "A look at the pairs", "sh 1", Shell("collection", path=ENV)),
    (COLLECTIONS, "Large collections", "sh 1", Shell("collection", path=ENV)),
    (COLLECTIONS, "Scores of the matches", "sh 1", Shell("collection", path=ENV, before=SCORES_OF_HLOC)),
    (COLLECTIONS, "Large collections", "sh 2", Skipped("test_usac_collection_engine.py runs with workers")),
    (COLLECTIONS, "Matches outside of a database", "python 1", Python(before="import os\nos.mkdir('folder')", where="collection")),
    (COLLECTIONS, "Matches outside of a database", "sh 1", Shell("collection", path=ENV)),
    (COLLECTIONS, "Matches outside of a database", "python 2", Python(where="collection")),
    (README, "Collections", "sh 1", Shell(before="cp ../collection/scene.db . && ln -s ../collection/images images")),

    (CONTRIBUTING, "The loop", "sh 1", Shell(
        names={"--runs=4": "--runs=1"}, without=("bash modules/usac/misc/check_sources.sh",))),
    (CONTRIBUTING, "The loop", "sh 2", Skipped("commands that start the tests, write stored results or need hours")),
    (CONTRIBUTING, "Reliability", "sh 1", Skipped("commands that start the tests, write stored results or need hours")),
    (CONTRIBUTING, "Results that change", "sh 1", Skipped("commands that start the tests, write stored results or need hours")),

    # Blocks of the benchmark's document, on lists of one pair.
    (BENCHMARK, "Quick start", "sh 1", Shell("benchmark", before=FIRST_LIST, without=(
        "python3 modules/usac/benchmark/dataset.py strecha --images=DIR/strecha --out=DATA --pairs=50",))),
    (BENCHMARK, "Format of pairs and lists", "python 1", Python(FILES + "gt_points = np.c_[points1, points2][right]")),
    (BENCHMARK, "Building pairs", "sh 1", Skipped("needs data sets, OpenCV's source or hours, or is run by run_tests.sh")),
    (BENCHMARK, "Synthetic scenes", "sh 1", Shell("benchmark", names=dict(FEW, **{"--out=DATA": "--out=plane"}))),
    (BENCHMARK, "Running", "sh 1", Shell("benchmark", before=LISTS)),
    (BENCHMARK, "Your own method", "sh 1", Shell("benchmark")),
    (BENCHMARK, "Your own method", "cmake 1", CMake(
        ("-DCMAKE_LINK_LIBRARIES_ONLY_TARGETS=ON",), names={"/path/to/opencv_usac": "{project}"}, whole="mine.cpp", build=False)),
    (BENCHMARK, "Comparing pair by pair", "sh 1", Shell(
        "benchmark", names={"compare.py": "modules/usac/benchmark/compare.py", "[": "", "]": "", " --other=...": ""}, before=RUNS)),
    (BENCHMARK, "Drawing", "sh 1", Shell(
        "benchmark", names={"plot.py": "modules/usac/benchmark/plot.py", "[": "", "]": "", "--out=DIR": "--out=drawn"}, before=RUNS)),
    (BENCHMARK, "Measurements", "sh 1", Skipped("needs data sets, OpenCV's source or hours, or is run by run_tests.sh")),
    (BENCHMARK, "Scale", "sh 1", Shell("benchmark", names={
        "> scale.md": "--problems=H --sizes 100 1000 --parts 0.8 0.5 --repeats=1 > scale.md", "[": "", "]": "", "--out=DIR": "--out=scale"})),
    (BENCHMARK, "Sensitivity to the threshold", "sh 1", Shell("benchmark")),
    (BENCHMARK, "Performance tests", "sh 1", Skipped("needs data sets, OpenCV's source or hours, or is run by run_tests.sh")),
    (BENCHMARK, "Tests", "sh 1", Skipped("needs data sets, OpenCV's source or hours, or is run by run_tests.sh")),
]
