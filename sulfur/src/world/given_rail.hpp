// The rail of a slider as a caller gives it.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <sulfur/error.hpp>
#include <vector>

#include "model/state.hpp"

namespace sulfur::detail {

/// The joints of a rail (dense). Throws unless they are those of a body, in the order of a line.
inline std::vector<std::uint32_t> railOf(const State& state, std::uint32_t body,
                                         std::span<const JointId> links) {
    if (links.empty())
        throw Error(ErrorCode::degenerate,
                    "slider: the rail has no joint; allowed is at least one");
    std::vector<std::uint32_t> joints;
    for (std::size_t k = 0; k < links.size(); ++k) {
        const std::string named = "slider: joint " + std::to_string(k) + " of the rail ";
        if (!state.jointSlots.contains(links[k]))
            throw Error(ErrorCode::staleHandle,
                        named + "refers to nothing; allowed is one that is there");
        joints.push_back(state.jointSlots.dense(links[k]));
        if (state.joints.body[joints.back()] != body)
            throw Error(ErrorCode::degenerate,
                        named + "is not of the first body; allowed are joints of that body");
    }
    auto sorted = joints;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        throw Error(ErrorCode::degenerate,
                    "slider: a joint is in the rail twice; allowed is each joint once");
    return joints;
}

/// The particles that the links of a rail go through, one more than links.
inline std::vector<std::uint32_t> nodesOfRail(const State& state,
                                              const std::vector<std::uint32_t>& rail) {
    const auto& a = state.joints.a;
    const auto& b = state.joints.b;
    const auto isEnd = [&](std::uint32_t p, std::uint32_t j) { return a[j] == p || b[j] == p; };
    const bool isTurned = rail.size() > 1 && !isEnd(b[rail[0]], rail[1]);
    std::vector<std::uint32_t> nodes{isTurned ? b[rail[0]] : a[rail[0]]};
    for (std::size_t k = 0; k < rail.size(); ++k) {
        if (!isEnd(nodes.back(), rail[k]))
            throw Error(ErrorCode::degenerate,
                        "slider: joint " + std::to_string(k) +
                            " of the rail does not begin where the one before ends; allowed are "
                            "joints in the order of a line");
        nodes.push_back(a[rail[k]] == nodes.back() ? b[rail[k]] : a[rail[k]]);
    }
    return nodes;
}

}  // namespace sulfur::detail
