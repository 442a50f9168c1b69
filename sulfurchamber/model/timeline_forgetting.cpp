// What a timeline forgets so that its bytes and its time stay bounded.
#include <algorithm>
#include <iterator>

#include "timeline_record.hpp"

namespace sulfurchamber {

void Timeline::trim(const sulfur::World& world) {
    const std::uint64_t longest = ticksOf(world, limits_.longest);
    while (last(line_) - first(line_) > longest)
        if (!dropOldestOfLine()) break;
    // Unpacking another group takes room too.
    const std::size_t spare = growing_.bytes.size();
    while (bytes() + spare > limits_.bytes)
        if (!dropOldestOther() && !dropOldestOfLine()) return;
}

// The branch beside the line that was shown longest ago, then what of the line's own branches is
// beside it.
bool Timeline::dropOldestOther() {
    const auto path = pathTo(line_);
    std::uint32_t oldest = 0;
    for (const auto& [id, branch] : branches_) {
        if (std::find(path.begin(), path.end(), id) != path.end()) continue;
        if (oldest == 0 || branch.used < at(oldest).used) oldest = id;
    }
    if (oldest != 0) {
        dropFront(oldest);
        return true;
    }
    // Futures of those on the line.
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        Branch& branch = at(path[i]);
        const std::uint64_t parted = at(path[i + 1]).begin;
        if (branch.last <= parted) continue;
        while (branch.keys.back().tick > parted) {  // the first is not
            packed_ -= branch.keys.back().packed.size();
            branch.keys.pop_back();
        }
        branch.last = parted;
        std::erase_if(branch.inputs, [&](const auto& input) { return input.tick >= parted; });
        std::erase_if(branch.marks, [&](const auto& mark) { return mark.tick > parted; });
        return true;
    }
    return false;
}

bool Timeline::dropOldestOfLine() {
    const std::uint32_t id = pathTo(line_).front();
    const Branch& branch = at(id);
    // The last group stays: the world must be able to come back to what it just was.
    if (id == line_ && branch.keys.front().base == branch.keys.back().base) return false;
    dropFront(id);
    return true;
}

// A key with all that differ from it. No line leads across what is gone: what comes after it and
// what parted from it begin by themselves.
void Timeline::dropFront(std::uint32_t id) {
    Branch& branch = at(id);
    const std::uint64_t base = branch.keys.front().base;
    std::erase_if(branch.keys, [&](const Key& key) {
        if (key.base == base) packed_ -= key.packed.size();
        return key.base == base;
    });
    const bool gone = branch.keys.empty();
    cut(branch);
    if (!gone) branch.begin = branch.keys.front().tick;
    for (auto& [other, child] : branches_)
        if (child.parent == id && (gone || child.begin < branch.begin)) cut(child);
    if (gone) {
        branches_.erase(id);
        return;
    }
    std::erase_if(branch.inputs, [&](const auto& input) { return input.tick < branch.begin; });
    std::erase_if(branch.marks, [&](const auto& mark) { return mark.tick < branch.begin; });
}

// From those that it came from. It keeps who had touched before.
void Timeline::cut(Branch& branch) {
    std::uint64_t until = branch.begin;
    for (std::uint32_t id = branch.parent; id != 0; id = at(id).parent) {
        for (const Seen& one : at(id).seen)
            if (one.tick <= until) branch.seen.push_back(one);
        until = std::min(until, at(id).begin);
    }
    branch.parent = 0;
}

}  // namespace sulfurchamber
