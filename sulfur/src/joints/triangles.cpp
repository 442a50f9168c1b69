#include "joints/triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/settings.hpp"
#include "joints/classify.hpp"
#include "kernels/joint_sweep.hpp"

namespace sulfur::detail {

namespace {

/// Beyond, a body is no lattice.
constexpr std::size_t mostToJoint = 4;

using tuned::flattest;

/// A joint from its particle of the smaller index.
struct Link {
    std::uint32_t low = none, high = none, joint = none;

    friend bool operator<(const Link& p, const Link& q) {
        return p.low != q.low ? p.low < q.low : p.high < q.high;
    }
};

class Finder {
public:
    explicit Finder(State& state) : state_(state) {}

    void find(const BodyRecord& body) {
        collectLinks(body);
        std::vector<Triangle>& all = state_.triangles.all;
        const std::size_t before = all.size(), most = mostToJoint * links_.size();
        for (const Link& link : links_) {
            const auto fromHigh = linksFrom(link.high);
            if (fromHigh.empty()) continue;
            for (const Link& other : linksFrom(link.low))
                if (link.high < other.high) close(link, other, fromHigh);
            if (all.size() - before <= most) continue;
            all.resize(before);
            return;
        }
    }

private:
    /// Each pair of particles once.
    void collectLinks(const BodyRecord& body) {
        const Joints& joints = state_.joints;
        links_.clear();
        for (const JointId id : body.joints) {
            const auto j = state_.jointSlots.dense(id);
            const auto [low, high] = std::minmax(joints.a[j], joints.b[j]);
            links_.push_back({low, high, j});
        }
        std::stable_sort(links_.begin(), links_.end());
        const auto same = [](const Link& p, const Link& q) {
            return p.low == q.low && p.high == q.high;
        };
        links_.erase(std::unique(links_.begin(), links_.end(), same), links_.end());
    }

    std::span<const Link> linksFrom(std::uint32_t particle) const {
        const auto first = std::lower_bound(links_.begin(), links_.end(), Link{particle, 0, none});
        const auto last = std::lower_bound(first, links_.end(), Link{particle + 1, 0, none});
        return {first, last};
    }

    /// Two joints of one particle, and the joints of the other end of the first.
    void close(const Link& ab, const Link& ac, std::span<const Link> fromB) {
        const Link wanted{ab.high, ac.high, none};
        const auto bc = std::lower_bound(fromB.begin(), fromB.end(), wanted);
        if (bc == fromB.end() || wanted < *bc) return;
        if (!mayTurnOver(ab, ac, *bc)) return;
        if (addTriangle(ab, ac, *bc)) brace(ab, ac, *bc);
    }

    /// The springs of a triangle hold each other.
    void brace(const Link& ab, const Link& ac, const Link& bc) {
        const std::array sides{ab.joint, ac.joint, bc.joint};
        for (const auto j : sides)
            if (isRigid(state_.joints, j)) return;
        for (const auto j : sides) state_.joints.braced[j] = 1;
    }

    bool mayTurnOver(const Link& ab, const Link& ac, const Link& bc) const {
        const Joints& joints = state_.joints;
        const auto& cluster = state_.particles.cluster;
        const auto rigid = [&](const Link& link) { return isRigid(joints, link.joint); };
        if (rigid(ab) && rigid(ac) && rigid(bc)) return false;
        const auto a = ab.low, b = ab.high, c = ac.high;
        return cluster[a] == none || cluster[a] != cluster[b] || cluster[a] != cluster[c];
    }

    /// The lengths at rest tell the area (Heron), the places in the blueprint on which side it is.
    /// Returns whether it is one.
    bool addTriangle(const Link& ab, const Link& ac, const Link& bc) {
        const auto squared = [&](const Link& link) {
            const double length = static_cast<double>(state_.joints.restLength[link.joint]);
            return length * length;
        };
        const double p = squared(ab), q = squared(ac), r = squared(bc), sum = p + q + r;
        const double twice16 = sum * sum - 2 * (p * p + q * q + r * r);  // 4 (twice the area)^2
        if (!(twice16 > 4 * flattest * flattest * sum * sum)) return false;
        const auto& rest = state_.particles.rest;
        const Vec2 toB = rest[ab.high] - rest[ab.low], toC = rest[ac.high] - rest[ac.low];
        const double side = static_cast<double>(cross(toB, toC));
        if (!(std::abs(side) > flattest * sum)) return false;
        const auto area = static_cast<Real>(std::sqrt(twice16) / 2);
        if (side > 0)
            state_.triangles.all.push_back({ab.low, ab.high, ac.high, area});
        else
            state_.triangles.all.push_back({ab.low, ac.high, ab.high, area});
        return true;
    }

    State& state_;
    std::vector<Link> links_;
};

/// What moves in steps of its own answers pushes in a way of its own, and has but one side.
bool inTree(const State& state, std::uint32_t particle) {
    const auto tree = state.trees.ofParticle[particle];
    return tree != none && state.trees.list[tree].alone;
}

/// Whether one rigid component has all of it.
bool isOneComponent(const State& state, const BodyRecord& body) {
    const auto first = state.particles.cluster.begin() + body.firstParticle;
    const auto last = first + static_cast<std::ptrdiff_t>(body.particles.size());
    return *first != none && std::all_of(first, last, [&](auto c) { return c == *first; });
}

}  // namespace

void AwakeTriangles::clear() {
    for (auto* corners : {&a, &b, &c, &held}) corners->clear();
    rest.clear();
    count = 0;
}

void AwakeTriangles::add(const Triangle& triangle, bool isHeld) {
    if (isHeld) held.push_back(static_cast<std::uint32_t>(count));
    a.push_back(2 * triangle.a);
    b.push_back(2 * triangle.b);
    c.push_back(2 * triangle.c);
    rest.push_back(triangle.rest);
    ++count;
}

/// With triangles of one point, which are never flatter than at rest.
void AwakeTriangles::fillBlocks() {
    const std::size_t blocks = (count + sweepLanes - 1) / sweepLanes;
    for (auto* corners : {&a, &b, &c}) corners->resize(blocks * sweepLanes, 0);
    rest.resize(blocks * sweepLanes, 0);
    flat.assign(blocks, 0);
    pressed.assign(blocks, 0);
}

void forgetTriangles(State& state) {
    state.triangles.bodies = 0;
    std::fill(state.joints.braced.begin(), state.joints.braced.end(), std::uint8_t{0});
}

void findTriangles(State& state) {
    Triangles& triangles = state.triangles;
    if (triangles.bodies == 0) triangles.all.clear();
    Finder finder(state);
    for (; triangles.bodies < state.bodies.size(); ++triangles.bodies) {
        const BodyRecord& body = state.bodies[triangles.bodies];
        if (body.kind == BodyKind::dynamic && body.joints.size() > 2 &&
            !isOneComponent(state, body))
            finder.find(body);
    }
}

void listTriangles(State& state) {
    Triangles& triangles = state.triangles;
    findTriangles(state);  // a restored world has none yet
    triangles.awake.clear();
    const auto moves = [&](std::uint32_t particle) {
        return inverseMassAwake(state, particle) > 0 || state.particles.cluster[particle] != none;
    };
    const auto isHeld = [&](std::uint32_t particle) {
        return state.particles.cluster[particle] != none;
    };
    for (const Triangle& t : triangles.all) {
        if (!state.awake(state.particles.body[t.a])) continue;
        if (!moves(t.a) && !moves(t.b) && !moves(t.c)) continue;
        if (inTree(state, t.a) || inTree(state, t.b) || inTree(state, t.c)) continue;
        triangles.awake.add(t, isHeld(t.a) || isHeld(t.b) || isHeld(t.c));
    }
    triangles.awake.fillBlocks();
    triangles.pressed.clear();
}

}  // namespace sulfur::detail
