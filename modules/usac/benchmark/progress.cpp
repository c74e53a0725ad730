// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "progress.hpp"

#include <cstdio>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace benchmark {

namespace {

bool isTerminal()
{
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

}  // namespace

Progress::Progress(int total_) : total(total_), done(0), active(isTerminal()), drawn(false) {}

void Progress::step(const std::string& what)
{
    const int before = done++;
    if (!active || total <= 0)
        return;
    const int width = 30, filled = (int)((long long)width * before / total);
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    std::fprintf(stderr, "\r[%s] %3d %% %-36.36s", bar.c_str(), (int)(100LL * before / total),
                 what.c_str());
    std::fflush(stderr);
    drawn = true;
}

void Progress::clear()
{
    if (drawn)
        std::fprintf(stderr, "\r%79s\r", "");
    drawn = false;
}

}  // namespace benchmark
