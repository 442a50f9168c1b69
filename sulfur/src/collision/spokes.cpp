#include "collision/spokes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "world/state.hpp"

namespace sulfur::detail {

namespace {

using Spoke = std::pair<std::uint32_t, std::uint32_t>;  // (corner, other end)

bool isFixed(const State& state, std::uint32_t particle) {
    return state.bodies[state.particles.body[particle]].kind == BodyKind::fixed;
}

/// Gives all fixed ends of one spot the spokes of each other.
void shareSpots(const State& state, std::vector<Spoke>& spokes) {
    const auto& x = state.particles.position;
    const auto before = [&](const Spoke& p, const Spoke& q) {
        return std::tie(x[p.first][0], x[p.first][1], p) <
               std::tie(x[q.first][0], x[q.first][1], q);
    };
    std::vector<Spoke> fixed;
    for (const Spoke& s : spokes)
        if (isFixed(state, s.first)) fixed.push_back(s);
    std::sort(fixed.begin(), fixed.end(), before);
    for (auto first = fixed.begin(); first != fixed.end();) {
        const auto last = std::find_if(
            first, fixed.end(), [&](const Spoke& s) { return x[s.first] != x[first->first]; });
        for (auto p = first; p != last; ++p)
            for (auto q = first; q != last; ++q)
                if (p->first != q->first) spokes.emplace_back(p->first, q->second);
        first = last;
    }
}

}  // namespace

void findSpokes(const State& state, Spokes& result) {
    result.start.assign(1, 0);
    result.end.clear();
    addSpokes(state, {}, result);
}

void addSpokes(const State& state, const Counts& before, Spokes& result) {
    const Joints& joints = state.joints;
    std::vector<Spoke> spokes;
    for (std::size_t j = before.joints; j < joints.size(); ++j) {
        if (joints.radius[j] <= 0) continue;
        spokes.emplace_back(joints.a[j], joints.b[j]);
        spokes.emplace_back(joints.b[j], joints.a[j]);
    }
    shareSpots(state, spokes);
    std::sort(spokes.begin(), spokes.end());
    spokes.erase(std::unique(spokes.begin(), spokes.end()), spokes.end());
    result.start.resize(state.particles.size() + 1, 0);
    for (const auto& [corner, end] : spokes) {
        ++result.start[corner + 1];
        result.end.push_back(end);
    }
    for (std::size_t i = before.particles + 1; i < result.start.size(); ++i)
        result.start[i] += result.start[i - 1];
}

}  // namespace sulfur::detail
