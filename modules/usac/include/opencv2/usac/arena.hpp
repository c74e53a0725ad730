// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ARENA_HPP
#define OPENCV_USACV20_ARENA_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include <new>
#include <type_traits>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @brief The memory of the runs of a Usac: usually one block (several if more than 31 MB are
needed), which the next run reuses.

Memory from take() stays valid until the run ends, memory from a Scope until that scope ends. take()
uses the low end of the block and a Scope the high end, so that a component can call take() while a
scope of its caller is open. When a block is full, another block is added; the next reset() replaces
all blocks with one of up to 31 MB, unless the first block is large enough. The memory is not
initialized, and no constructors or destructors are called. Only one thread at a time is allowed to
use an arena. */
class CV_EXPORTS Arena
{
    struct Block;

public:
    //! @param bytes size of the first block; 0: the first block is allocated when memory is needed
    explicit Arena(size_t bytes = 0);
    ~Arena();

    //! Returns uninitialized, 64-byte aligned memory for `count` objects, valid until the run ends.
    //! Never null, even if `count` is 0.
    template <class T>
    T* take(size_t count)
    {
        return static_cast<T*>(low(bytesOf<T>(count)));
    }
    //! Makes later calls of clear() leave everything taken so far valid.
    void keep();
    //! Starts a new run: frees what was taken since keep(), or everything if keep() was not called.
    //! All scopes must have ended.
    void clear();
    //! Frees everything. If the first block is smaller than the maximum of `bytes` and capacity()
    //! (but at most 31 MB), one block of at least this size replaces all blocks; otherwise the
    //! blocks are kept.
    void reset(size_t bytes);

    //! Number of blocks.
    int blocks() const;
    //! Bytes in all blocks.
    size_t capacity() const;

    //! Memory that is freed when the scope ends. Scopes end in reverse order of their construction.
    class CV_EXPORTS Scope
    {
    public:
        //! Opens a scope that takes its memory from this arena.
        explicit Scope(Arena& arena);
        ~Scope();
        //! Like Arena::take, but the memory is valid only until the scope ends.
        template <class T>
        T* take(size_t count)
        {
            return static_cast<T*>(arena.high(bytesOf<T>(count)));
        }

    private:
        Arena& arena;
        Block* const block;  //!< Arena::top at construction; `end` is its Block::high at that time
        char* const end;

        Scope(const Scope&);
        Scope& operator=(const Scope&);
    };

private:
    template <class T>
    static size_t bytesOf(size_t count)
    {
        static_assert(std::is_trivially_destructible<T>::value, "an arena calls no destructors");
        if (count > ((size_t)-1) / 2 / sizeof(T))
            CV_Error(Error::StsNoMem, "count: more memory than can be addressed");
        return count * sizeof(T);
    }

    void* low(size_t bytes);
    void* high(size_t bytes);
    Block* add(size_t bytes);
    void release();

    Block* first;
    Block* top;  //!< the block from whose high end high() takes memory

    Arena(const Arena&);
    Arena& operator=(const Arena&);
};

//! A growing list whose elements are stored in an arena, and stay valid as long as memory from
//! Arena::take. Copies of a list share the elements.
template <class T>
class ArenaList
{
public:
    ArenaList() : items(0), count(0), room(0) {}

    //! Appends a copy of `item`. A full list is first moved to an array of twice the capacity.
    void push(Arena& arena, const T& item)
    {
        const T copy = item;  // `item` can be an element of this list
        if (count == room)
        {
            room = room > 0 ? 2 * room : (int)FIRST;
            T* const larger = arena.take<T>(room);
            for (int i = 0; i < count; ++i)
                new (larger + i) T(items[i]);
            items = larger;
        }
        new (items + count++) T(copy);
    }

    int size() const { return count; }         //!< number of elements
    bool empty() const { return count == 0; }  //!< true if there are no elements
    //! Shortens the list to `size_` elements; never lengthens it.
    void resize(int size_) { count = std::min(count, size_); }
    T& operator[](int i) { return items[i]; }              //!< element 0 <= i < size(), unchecked
    const T& operator[](int i) const { return items[i]; }  //!< the same
    T& back() { return items[count - 1]; }                 //!< the last element; there must be one
    const T& back() const { return items[count - 1]; }     //!< the same
    const T* begin() const { return items; }               //!< the first element
    const T* end() const { return items + count; }         //!< past the last element

private:
    enum { FIRST = 32 };

    T* items;
    int count, room;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
