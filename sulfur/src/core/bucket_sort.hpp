// Sorting what has a small number as the first part of its order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

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

/// Sorts items whose order begins with keyOf(item), a number below `keys`: a counting sort by it,
/// then each bucket by <. Linear when buckets are small. `scratch` and `start` lend memory.
template <class Item, class KeyOf>
void bucketSort(std::vector<Item>& items, std::vector<Item>& scratch,
                std::vector<std::uint32_t>& start, std::size_t keys, KeyOf&& keyOf) {
    countingSort(items, scratch, start, keys, keyOf);
    std::uint32_t first = 0;
    for (std::size_t k = 0; k < keys; ++k) {
        if (start[k] - first > 1) std::sort(items.begin() + first, items.begin() + start[k]);
        first = start[k];
    }
}

}  // namespace sulfur::detail
