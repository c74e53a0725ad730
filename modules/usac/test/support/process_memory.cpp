// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/process_memory.hpp"

#ifdef __linux__

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace opencv_test {

namespace {

double peakBytes()
{
    rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? usage.ru_maxrss * 1024. : 0;
}

}  // namespace

bool memoryIsMeasurable()
{
    return !dlsym(RTLD_DEFAULT, "__asan_init") && !dlsym(RTLD_DEFAULT, "__tsan_init") &&
           residentBytes() > 0;
}

double residentBytes()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ifstream in("/proc/self/statm");
    double total = 0, resident = 0;
    in >> total >> resident;
    return resident * (double)sysconf(_SC_PAGESIZE);
}

PeakMemory::PeakMemory()
{
    const double resident = residentBytes();
    std::ofstream("/proc/self/clear_refs") << 5;  // resets the peak to the current value
    before = std::max(resident, peakBytes());
}

double PeakMemory::bytes() const { return std::max(peakBytes() - before, 0.); }

}  // namespace opencv_test

#else

namespace opencv_test {

bool memoryIsMeasurable() { return false; }
double residentBytes() { return 0; }
PeakMemory::PeakMemory() : before(0) {}
double PeakMemory::bytes() const { return before; }

}  // namespace opencv_test

#endif
