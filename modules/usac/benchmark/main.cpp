// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// The experiment of the USACv20 paper: compares the accuracy and the time of robust estimators on
// lists of image pairs.
//
//     usac_benchmark --data=<folder> --methods=USACV20,cv:USAC_DEFAULT --csv=tables.csv
//     --runs=runs.csv > tables.md
//
// The format of the data is described in doc/benchmark.md.

#include "benchmark.hpp"
#include "program.hpp"

int main(int argc, char** argv)
{
    return benchmark::runProgram(benchmark::runBenchmark, argc, argv);
}
