#include "solver/rails.hpp"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.hpp"
#include "shape/bends.hpp"
#include "solver/coordinates.hpp"

namespace sulfur::detail {

namespace {

constexpr double pointLike = 1e-12;  // m: a link without a direction
constexpr double sameWay = 1e-12;    // of directions: where lines go on in each other

ParticleId otherEnd(const State& state, std::uint32_t joint, ParticleId end) {
    const auto a = state.particles.id[state.joints.a[joint]];
    return a == end ? state.particles.id[state.joints.b[joint]] : a;
}

std::uint32_t linkOf(const State& state, const Mechanism& m, std::uint32_t link) {
    return state.jointSlots.dense(m.rail.links[link]);
}

/// The link after one, or before it, or none where the rail ends.
std::uint32_t nextTo(const State& state, const Rail& rail, std::uint32_t link, bool forward) {
    const auto count = static_cast<std::uint32_t>(rail.links.size());
    const std::uint32_t last = forward ? count - 1 : 0, first = forward ? 0 : count - 1;
    if (link == last && rail.closed == 0) return none;
    const std::uint32_t next = link == last ? first : forward ? link + 1 : link - 1;
    return next != link && state.jointSlots.contains(rail.links[next]) ? next : none;
}

/// The free end in one direction, in m of the coordinate; infinite where it is farther than `most`.
double freeEnd(const State& state, const Mechanism& m, bool forward, double most) {
    const double way = forward ? 1 : -1;
    double at = m.rail.begin - m.zero;
    if (forward) at += lengthOfLink(state, linkOf(state, m, m.rail.link));
    auto link = m.rail.link;
    for (std::size_t i = 0; i < m.rail.links.size() && way * (most - at) >= 0; ++i) {
        link = nextTo(state, m.rail, link, forward);
        if (link == none) return at;
        at += way * lengthOfLink(state, linkOf(state, m, link));
    }
    return nextTo(state, m.rail, link, forward) == none ? at : way * DriveLimits{}.upper;
}

/// Puts it on the neighbour, which `link` is.
void pass(const State& state, Mechanism& m, std::uint32_t link, bool forward) {
    const ParticleId begin = m.points[1].support[0], end = m.points[2].support[0];
    const double own = lengthOfLink(state, linkOf(state, m, m.rail.link));
    const auto joint = linkOf(state, m, link);
    m.rail.begin += forward ? own : -lengthOfLink(state, joint);
    putOnLink(state, m, link, forward ? end : otherEnd(state, joint, begin));
}

/// On which link it is.
struct Spot {
    std::uint32_t link;
    double begin;
    ParticleId from;
};
void goBack(const State& state, Mechanism& m, const Spot& to) {
    m.rail.begin = to.begin;
    putOnLink(state, m, to.link, to.from);
}

/// Where links meet at an angle, what comes from one at a speed (m/s) is deflected along the other
/// one by a blow along the bisector, which takes no energy. A rope that gives way takes some of it.
/// `turn`: by which the direction changes.
void deflect(State& state, const Mechanism& m, double speed, const Point& turn) {
    const double size = turn.norm();
    if (!(size > sameWay)) return;
    const CoordinateSlopes slopes = slopesFromLink(state, m, turn / size);
    const double mobility = freeMobility(slopes);
    if (mobility > 0) strike(state, slopes, std::abs(speed) * size / mobility);
}

}  // namespace

double lengthOfLink(const State& state, std::uint32_t joint) {
    const double chord = static_cast<double>(state.joints.restLength[joint]);
    const double half = std::abs(bendOf(state, joint)) / 2;
    return half > 0 ? chord * half / unitVector(half)[1] : chord;
}

OnRail onRail(const State& state, const Mechanism& m, bool moved) {
    const auto joint = linkOf(state, m, m.rail.link);
    const Point from = placeOf(state, m.points[1], moved);
    const Point chord = placeOf(state, m.points[2], moved) - from;
    const double size = chord.norm();
    OnRail on;
    on.length = lengthOfLink(state, joint);
    if (!(size > pointLike)) return on;
    const Point heading = chord / size;
    on.perLength = heading / size;
    on.share = turnedBack(heading, placeOf(state, m.points[0], moved) - from) / size;
    const bool isReversed = state.particles.id[state.joints.a[joint]] != m.points[1].support[0];
    const double bend = isReversed ? -bendOf(state, joint) : bendOf(state, joint);
    if (bend == 0) {
        on.place = on.length * on.share[0];
        on.off = size * on.share[1];
        on.along = on.length / size * heading;
        on.across = Point(-heading[1], heading[0]);
        return on;
    }
    // In the frame of the chord the centre is at 1/2 + i cot(bend / 2) / 2. `angle` is how far the
    // point is from the arc's middle, the way in which that turns.
    const double half = std::abs(bend) / 2, turns = bend < 0 ? -1 : 1;
    const Point u = unitVector(half);
    const Point arm = on.share - Point(0.5, turns * u[0] / (2 * u[1]));
    const double reach = arm.norm();
    if (!(reach * size > pointLike)) return on;
    const double angle = turns * angleOf(Point(-turns * arm[1], turns * arm[0]));
    const Point outwards = turned(heading, arm) / reach;
    on.place = on.length * (0.5 + angle / (2 * half));
    on.off = -turns * size * (reach - 1 / (2 * u[1]));
    on.along = turns * on.length / (2 * half * reach * size) * Point(-outwards[1], outwards[0]);
    on.across = -turns * outwards;
    return on;
}

DriveLimits limitsOf(const State& state, const Mechanism& m, double now, double reach) {
    const double lower = static_cast<double>(m.drive.lower);
    const double upper = static_cast<double>(m.drive.upper);
    if (m.rail.isNothing()) return {lower, upper};
    const double begin = freeEnd(state, m, false, now - reach);
    const double end = freeEnd(state, m, true, now + reach);
    return {std::clamp(lower, begin, end), std::clamp(upper, begin, end)};
}

RailRun runOf(const State& state, const Mechanism& m) {
    const Rail& rail = m.rail;
    const auto exists = [&](JointId id) { return state.jointSlots.contains(id); };
    const bool isWhole = std::all_of(rail.links.begin(), rail.links.end(), exists);
    RailRun run;
    run.begin = rail.begin - m.zero;
    auto first = rail.link;
    while (!(isWhole && first == 0)) {
        const auto before = nextTo(state, rail, first, false);
        if (before == none) break;
        first = before;
        run.begin -= lengthOfLink(state, linkOf(state, m, first));
    }
    for (auto link = first; link != none && run.links.size() < rail.links.size();
         link = nextTo(state, rail, link, true))
        run.links.push_back(rail.links[link]);
    return run;
}

void putOnLink(const State& state, Mechanism& m, std::uint32_t link, ParticleId from) {
    m.rail.link = link;
    const ParticleId ends[] = {from, otherEnd(state, linkOf(state, m, link), from)};
    for (std::size_t k = 0; k < 2; ++k) {
        m.points[k + 1] = {};
        m.points[k + 1].count = 1;
        m.points[k + 1].support[0] = ends[k];
        m.points[k + 1].weight[0] = 1;
    }
}

void followRail(State& state, Mechanism& m) {
    for (std::size_t i = 0; i < m.rail.links.size(); ++i) {
        const OnRail on = onRail(state, m, false);
        const bool forward = on.place > on.length;
        if (!(on.place < 0) && !forward) return;
        const auto next = nextTo(state, m.rail, m.rail.link, forward);
        if (next == none) return;
        const double speed = speedOf(state, m);  // of the middle of the last step, as it has passed
        const bool goesOn = forward ? speed > 0 : speed < 0;
        const Spot before{m.rail.link, m.rail.begin, m.points[1].support[0]};
        pass(state, m, next, forward);
        const OnRail there = onRail(state, m, false);
        const bool isThere = forward ? there.place > 0 : there.place < there.length;
        if (!goesOn && !isThere) return goBack(state, m, before);
        const Point turn = there.tangent() - on.tangent();
        if (goesOn) deflect(state, m, speed, forward ? turn : Point(-turn));
    }
}

}  // namespace sulfur::detail
