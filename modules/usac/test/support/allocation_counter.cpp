// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/allocation_counter.hpp"

// These definitions replace glibc's functions that allocate memory, for all code of the process:
// the linker prefers the symbols of a program to those of its libraries. operator new and
// cv::fastMalloc call these functions, too. The memory that they return is freed by free() of
// glibc.

#ifdef __GLIBC__

#include <atomic>
#include <cerrno>
#include <malloc.h>

namespace {

std::atomic<long> allocations(0);

void count() { allocations.fetch_add(1, std::memory_order_relaxed); }

}  // namespace

namespace opencv_test {

long allocationsSoFar() { return allocations.load(); }

}  // namespace opencv_test

extern "C"
{
    void* __libc_malloc(size_t size);
    void* __libc_calloc(size_t items, size_t size);
    void* __libc_realloc(void* memory, size_t size);
    void* __libc_memalign(size_t alignment, size_t size);

    void* malloc(size_t size) noexcept
    {
        count();
        return __libc_malloc(size);
    }

    void* calloc(size_t items, size_t size) noexcept
    {
        count();
        return __libc_calloc(items, size);
    }

    void* realloc(void* memory, size_t size) noexcept
    {
        count();
        return __libc_realloc(memory, size);
    }

    void* memalign(size_t alignment, size_t size) noexcept
    {
        count();
        return __libc_memalign(alignment, size);
    }

    void* aligned_alloc(size_t alignment, size_t size) noexcept
    {
        count();
        return __libc_memalign(alignment, size);
    }

    int posix_memalign(void** memory, size_t alignment, size_t size) noexcept
    {
        count();
        *memory = __libc_memalign(alignment, size);
        return *memory ? 0 : ENOMEM;
    }
}

#endif
