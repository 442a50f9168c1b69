// Memory before it is needed: a call of World takes all that it may need before it changes
// anything, so that it is obeyed or, where there is no memory, has changed nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sulfur::detail {

/// So many elements can be added without taking memory. Grows as adding would.
template <class T>
void makeRoom(std::vector<T>& list, std::size_t more) {
    const std::size_t needed = list.size() + more;
    if (needed > list.capacity()) list.reserve(std::max(needed, 2 * list.capacity()));
}

/// The list can become as long as that without taking memory.
template <class T>
void makeRoomFor(std::vector<T>& list, std::size_t size) {
    if (size > list.size()) makeRoom(list, size - list.size());
}

}  // namespace sulfur::detail
