// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ARENA_HPP
#define OPENCV_USACV20_ARENA_HPP

#ifndef OPENCV_BINDING_PARSER  // nothing here is for other languages

#include <new>
#include <type_traits>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief The memory of the runs of a Usac: one block as a rule (of more than 31 MB, several),
which the next run uses again.

What is taken stays until the run ends; what a Scope has taken, until the scope ends. The first
grows from the low end of the block, the second from the high end, so that neither is in the way of
the other: a component may make what it keeps while a scope of its caller is open. Where a block is
full another one is added; the next reset() makes one of all. Nothing is initialized, constructed or
destroyed. For one thread at a time. */
class CV_EXPORTS Arena
{
    struct Block;

public:
    //! @param bytes of the first block; 0: it is made when the first memory is taken
    explicit Arena(size_t bytes = 0);
    ~Arena();

    //! Room for `count` objects until the run ends, 64-byte aligned, uninitialized. Not null, also
    //! if `count` is 0.
    template <class T>
    T* take(size_t count)
    {
        return static_cast<T*>(low(bytesOf<T>(count)));
    }
    //! What has been taken up to now is not freed by clear().
    void keep();
    //! A new run: frees what has been taken since keep(), or all. No Scope may be open.
    void clear();
    //! Frees everything; then there is one block of `bytes` at least, and as large as all before if
    //! these were more. Of more than 31 MB, those that there are stay, and others are added as they
    //! are needed.
    void reset(size_t bytes);

    //! Number of blocks.
    int blocks() const;
    //! Bytes of all blocks.
    size_t capacity() const;

    //! What it takes is free again when it ends. Scopes end in the reverse order of their making.
    class CV_EXPORTS Scope
    {
    public:
        //! Begins: memory is taken from this arena.
        explicit Scope(Arena& arena);
        ~Scope();
        //! As Arena::take, until the scope ends.
        template <class T>
        T* take(size_t count)
        {
            return static_cast<T*>(arena.high(bytesOf<T>(count)));
        }

    private:
        Arena& arena;
        Block* const block;  //!< whose high end was in use, and to where
        char* const end;

        Scope(const Scope&);
        Scope& operator=(const Scope&);
    };

private:
    template <class T>
    static size_t bytesOf(size_t count)
    {
        static_assert(std::is_trivially_destructible<T>::value,
                      "nobody destroys what is in an arena");
        if (count > ((size_t)-1) / 2 / sizeof(T))
            CV_Error(Error::StsNoMem, "more memory than there can be");
        return count * sizeof(T);
    }

    void* low(size_t bytes);
    void* high(size_t bytes);
    Block* add(size_t bytes);
    void release();

    Block* first;
    Block* top;  //!< the block whose high end is in use

    Arena(const Arena&);
    Arena& operator=(const Arena&);
};

//! A list that grows in an arena: it is valid as long as what has been taken there. A copy has the
//! same elements.
template <class T>
class ArenaList
{
public:
    ArenaList() : items(0), count(0), room(0) {}

    //! Adds a copy of an element, which may be one of the list; a list that is full moves to a
    //! larger place of the arena.
    void push(Arena& arena, const T& item)
    {
        const T copy = item;  // which may be one of the list
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
    bool empty() const { return count == 0; }  //!< no elements?
    //! Shortens the list.
    void resize(int size_) { count = std::min(count, size_); }
    T& operator[](int i) { return items[i]; }              //!< element 0 <= i < size(), unchecked
    const T& operator[](int i) const { return items[i]; }  //!< the same
    T& back() { return items[count - 1]; }                 //!< the last element; there must be one
    const T& back() const { return items[count - 1]; }     //!< the same
    const T* begin() const { return items; }               //!< the first element
    const T* end() const { return items + count; }         //!< behind the last element

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
