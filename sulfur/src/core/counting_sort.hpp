// Sorting by small numbers.
#pragma once

#include <cstddef>
#include <utility>

namespace sulfur::detail {

/// Sorts items by keyOf(item), a number below `keys`; those of one key keep their order. Leaves the
/// end of each key's items in start[key]. `scratch` and `start` lend memory.
template <class Items, class Starts, class KeyOf>
void countingSort(Items& items, Items& scratch, Starts& start, std::size_t keys, KeyOf&& keyOf) {
    start.assign(keys + 1, 0);
    for (const auto& item : items) ++start[keyOf(item) + 1];
    for (std::size_t k = 1; k <= keys; ++k) start[k] += start[k - 1];
    scratch.resize(items.size());
    for (const auto& item : items) scratch[start[keyOf(item)]++] = item;
    std::swap(items, scratch);
}

}  // namespace sulfur::detail
