// Generational handles to the entries of dense arrays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <vector>

#include "core/room.hpp"

namespace sulfur::detail {

inline constexpr std::uint32_t none = 0xffffffffu;

/// Hands out handles and knows at which dense index each thing is now. Freed slots are reused in
/// last-in-first-out order, with a new generation.
template <class Id>
class Slots {
public:
    Id insert(std::uint32_t denseIndex) {
        std::uint32_t slot;
        if (!free_.empty()) {
            slot = free_.back();
            free_.pop_back();
        } else {
            slot = static_cast<std::uint32_t>(dense_.size());
            dense_.push_back(none);
            generation_.push_back(0);
        }
        dense_[slot] = denseIndex;
        return {slot + 1, ++generation_[slot]};
    }

    /// So many handles can be given out, and all that there are be erased, without taking memory.
    void makeRoom(std::size_t more) {
        detail::makeRoom(dense_, more);
        detail::makeRoom(generation_, more);
        makeRoomFor(free_, dense_.size() + more);
    }

    void erase(Id id) {
        dense_[id.index - 1] = none;
        free_.push_back(id.index - 1);
    }

    /// The handle is void from now on. The slot stays taken until it is erased.
    void retire(Id id) { dense_[id.index - 1] = none; }

    bool contains(Id id) const {
        return id.index != 0 && id.index <= dense_.size() &&
               generation_[id.index - 1] == id.generation && dense_[id.index - 1] != none;
    }

    /// The largest index of any handle that was given out.
    std::size_t slots() const { return dense_.size(); }
    std::uint32_t dense(Id id) const { return dense_[id.index - 1]; }
    /// By slot, which is a handle's index less 1 and never changes; none where nothing lives.
    std::uint32_t denseOf(std::uint32_t slot) const { return dense_[slot]; }
    void move(Id id, std::uint32_t denseIndex) { dense_[id.index - 1] = denseIndex; }

    /// Whether the lists fit each other, as those that an archive has read may not.
    bool sound() const {
        if (dense_.size() != generation_.size()) return false;
        return std::all_of(free_.begin(), free_.end(),
                           [&](std::uint32_t slot) { return slot < dense_.size(); });
    }

    template <class Archive>
    void archive(Archive& a) {
        a(dense_);
        a(generation_);
        a(free_);
    }

    /// Bytes in use.
    std::size_t bytes() const {
        return (dense_.size() + generation_.size() + free_.size()) * sizeof(std::uint32_t);
    }

private:
    std::vector<std::uint32_t> dense_;
    std::vector<std::uint32_t> generation_;
    std::vector<std::uint32_t> free_;
};

}  // namespace sulfur::detail
