// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "opencv2/usac/arena.hpp"

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define USAC_ADDRESS_SANITIZER
#endif
#endif
#if defined __SANITIZE_ADDRESS__ || defined USAC_ADDRESS_SANITIZER
#include <sanitizer/asan_interface.h>
#define USAC_FORBID(from, to) __asan_poison_memory_region(from, (size_t)((to) - (from)))
#define USAC_ALLOW(from, bytes) __asan_unpoison_memory_region(from, bytes)
#define USAC_GAP ALIGNMENT  // unused bytes behind each array: an overrun is detected there
#else
#define USAC_FORBID(from, to) (void)0
#define USAC_ALLOW(from, bytes) (void)0
#define USAC_GAP 0
#endif

namespace cv {
namespace usacv20 {

namespace {

constexpr int ALIGNMENT = 64;
/** Smallest and largest size of a block in bytes; only a block for a single larger request exceeds
LARGEST. If glibc returns the memory of a destroyed Usac to the system, the next Usac causes a page
fault for each page that it writes to; these faults take a quarter of the time of a run. glibc
keeps the memory if a separately mapped block (128 kB to 32 MB) was freed before and at most twice
its size is free now. Therefore SMALLEST is above 128 kB and LARGEST below 32 MB. Sizes in between
are SMALLEST times a power of 2, so that calls with slightly different numbers of points use the
same size. Pages that are never written to cost no time. */
constexpr size_t SMALLEST = 256 << 10, LARGEST = 31 << 20;

//! Size of a block that can hold `bytes`.
size_t blockSize(size_t bytes)
{
    size_t size = SMALLEST;
    while (size < bytes && size < LARGEST)
        size *= 2;
    return std::max(bytes, std::min(size, LARGEST));
}

size_t rounded(size_t bytes) { return (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT; }
size_t sizeOf(size_t bytes) { return rounded(bytes) + USAC_GAP; }

}  // namespace

//! Header of a block, directly in front of its memory.
struct Arena::Block
{
    Block* next;
    char *begin, *end;
    char* kept;  //!< clear() frees only the memory from here on
    char* low;   //!< end of the memory taken from the low end
    char* high;  //!< start of the memory taken from the high end

    size_t room() const { return (size_t)(high - low); }
};

Arena::Arena(size_t bytes) : first(0), top(0)
{
    if (bytes > 0)
        add(bytes);
}

Arena::~Arena() { release(); }

void Arena::release()
{
    while (first)
    {
        Block* const next = first->next;
        fastFree(first);
        first = next;
    }
    top = 0;
}

//! Appends a block of at least `bytes` and at least min(capacity(), LARGEST) bytes.
Arena::Block* Arena::add(size_t bytes)
{
    const size_t header = rounded(sizeof(Block)),
                 size = blockSize(std::max(rounded(bytes), std::min(capacity(), LARGEST)));
    char* const memory = (char*)fastMalloc(header + size);  // 64-byte aligned
    Block* const block = (Block*)memory;
    block->next = 0;
    block->begin = block->kept = block->low = memory + header;
    block->end = block->high = block->begin + size;
    USAC_FORBID(block->begin, block->end);
    Block** last = &first;
    while (*last)
        last = &(*last)->next;
    *last = block;
    if (!top)
        top = block;
    return block;
}

void* Arena::low(size_t bytes)
{
    const size_t size = sizeOf(bytes);
    Block* block = first;
    while (block && block->room() < size)
        block = block->next;
    if (!block)
        block = add(size);
    void* const taken = block->low;
    block->low += size;
    USAC_ALLOW(taken, bytes);
    return taken;
}

//! Only the block `top` and the blocks before it can have memory in use at their high ends.
void* Arena::high(size_t bytes)
{
    const size_t size = sizeOf(bytes);
    while (top && top->room() < size && top->next)
        top = top->next;
    if (!top || top->room() < size)
        top = add(size);
    top->high -= size;
    USAC_ALLOW(top->high, bytes);
    return top->high;
}

void Arena::keep()
{
    for (Block* block = first; block; block = block->next)
        block->kept = block->low;
}

void Arena::clear()
{
    for (Block* block = first; block; block = block->next)
    {
        block->low = block->kept;
        block->high = block->end;
        USAC_FORBID(block->low, block->high);
    }
    top = first;
}

void Arena::reset(size_t bytes)
{
    bytes = std::min(std::max(bytes, capacity()), LARGEST);
    if (first && (size_t)(first->end - first->begin) < bytes)
        release();
    if (!first && bytes > 0)
        add(bytes);
    if (first)
        first->kept = first->begin;
    clear();
}

int Arena::blocks() const
{
    int count = 0;
    for (const Block* block = first; block; block = block->next)
        ++count;
    return count;
}

size_t Arena::capacity() const
{
    size_t bytes = 0;
    for (const Block* block = first; block; block = block->next)
        bytes += (size_t)(block->end - block->begin);
    return bytes;
}

Arena::Scope::Scope(Arena& arena_)
    : arena(arena_), block(arena_.top), end(arena_.top ? arena_.top->high : 0)
{}

Arena::Scope::~Scope()
{
    Block* const mine = block ? block : arena.first;
    for (Block* after = mine; after; after = after->next)
    {
        after->high = after == block ? end : after->end;
        USAC_FORBID(after->low, after->high);
    }
    arena.top = mine;
}

}  // namespace usacv20
}  // namespace cv
