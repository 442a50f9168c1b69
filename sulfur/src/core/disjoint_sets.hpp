// Sets that are only ever united.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory_resource>
#include <numeric>
#include <vector>

namespace sulfur::detail {

/// Disjoint sets of 0 .. count - 1 (path halving; the smallest number of a set leads it, so that
/// the result does not depend on the order of the unions).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count = 0,
                          std::pmr::memory_resource* memory = std::pmr::get_default_resource())
        : parent_(memory) {
        reset(count);
    }

    void reserve(std::size_t count) { parent_.reserve(count); }
    void reset(std::size_t count) {
        parent_.assign(count, 0);
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// Returns false if they were in one set already.
    bool unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return false;
        parent_[std::max(a, b)] = std::min(a, b);
        return true;
    }

private:
    std::pmr::vector<std::uint32_t> parent_;
};

}  // namespace sulfur::detail
