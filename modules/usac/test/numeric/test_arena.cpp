// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of Arena, which owns the memory that a run uses.

namespace opencv_test {
namespace {

//! A piece of memory, and the value that all its bytes should have.
struct Piece
{
    uchar* begin;
    size_t size;
    uchar value;

    bool intact() const { return (size_t)std::count(begin, begin + size, value) == size; }
};

Piece fill(uchar* begin, size_t size, RNG& rng)
{
    const Piece piece = {begin, size, (uchar)rng.uniform(0, 256)};
    EXPECT_TRUE(begin && (size_t)begin % 64 == 0);
    std::fill(begin, begin + size, piece.value);
    return piece;
}

void expectIntact(const std::vector<Piece>& pieces)
{
    for (size_t i = 0; i < pieces.size(); ++i)
        ASSERT_TRUE(pieces[i].intact()) << i;
}

//! Makes nested scopes. In each scope, some pieces are taken from the scope and some from the
//! arena, which keeps them for the whole run. No piece must overlap another.
void useScopes(Arena& arena, RNG& rng, int depth, size_t largest, std::vector<Piece>& kept)
{
    const Arena::Scope untouched(arena);
    Arena::Scope scope(arena);
    std::vector<Piece> own;
    for (int i = 0; i < 6; ++i)
    {
        const size_t size = rng.uniform(0, (int)largest);
        if (i % 3 == 0 && depth > 0)
            useScopes(arena, rng, depth - 1, largest, kept);
        if (i % 2)
            own.push_back(fill(scope.take<uchar>(size), size, rng));
        else
            kept.push_back(fill(arena.take<uchar>(size), size, rng));
    }
    expectIntact(own);
    expectIntact(kept);
}

TEST(Usac_Arena, nothingOverlaps)
{
    RNG rng(3);
    for (size_t largest = 10; largest < 1000000; largest *= 20)
    {
        Arena arena;
        for (int run = 0; run < 3; ++run)
        {
            std::vector<Piece> kept;
            useScopes(arena, rng, 3, largest, kept);
            arena.clear();
        }
    }
}

//! Large blocks must be kept by reset() instead of being replaced by one block of their total size.
TEST(Usac_Arena, largeBlocksStay)
{
    Arena arena;
    arena.reset(100 << 20);
    EXPECT_EQ(1, arena.blocks());
    EXPECT_LE(arena.capacity(), (size_t)32 << 20);
    for (int i = 0; i < 5; ++i)
        arena.take<uchar>(20 << 20);
    const int blocks = arena.blocks();
    const size_t capacity = arena.capacity();
    EXPECT_LE(capacity, (size_t)200 << 20);
    arena.reset(100 << 20);
    for (int i = 0; i < 5; ++i)
        arena.take<uchar>(20 << 20);
    EXPECT_EQ(blocks, arena.blocks());
    EXPECT_EQ(capacity, arena.capacity());
    uchar* const one = arena.take<uchar>(40 << 20);  // larger than any block
    one[(40 << 20) - 1] = 1;
    EXPECT_EQ(blocks + 1, arena.blocks());
    EXPECT_THROW(arena.take<double>((size_t)-1 / 4), cv::Exception);
}

TEST(Usac_Arena, list)
{
    Arena arena;
    ArenaList<int> list;
    EXPECT_TRUE(list.empty());
    for (int i = 0; i < 1000; ++i)
    {
        list.push(arena, i > 0 ? list[0] + i : 0);
        *arena.take<int>(1) = -1;
        ASSERT_EQ(i, list.back());
    }
    list.push(arena, list.back());
    EXPECT_EQ(1001, list.size());
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(i, list[i]);
    list.resize(3);
    EXPECT_EQ(3, list.size());
    EXPECT_EQ(2, list.back());
    EXPECT_EQ(3, list.end() - list.begin());
}

}  // namespace
}  // namespace opencv_test
