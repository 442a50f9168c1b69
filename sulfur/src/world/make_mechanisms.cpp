// World: making mechanisms between bodies.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include "bodies/sleep.hpp"
#include "core/error_checks.hpp"
#include "core/limits.hpp"
#include "core/room.hpp"
#include "core/trigonometry.hpp"
#include "solver/compact.hpp"
#include "solver/coordinates.hpp"
#include "solver/mechanisms.hpp"
#include "solver/rails.hpp"
#include "world/given_rail.hpp"
#include "world/impl.hpp"

namespace sulfur {

using detail::Mechanism;
using detail::MechanismArm;
using detail::MechanismPoint;
using detail::RowOf;
using detail::State;

namespace {

constexpr double farthestValue = 1e6;  // rad or m, either way
constexpr double tied = 1e-6;  // of a link: what is as near to two of a rail is on the first one

/// Whom a mechanism is about to join.
struct Couple {
    std::uint32_t a, b;  // dense
};

std::uint32_t indexOfEnd(const State& state, BodyId id, const char* which) {
    try {
        return indexOf(state, id);
    } catch (const Error& e) {
        throw Error(e.code(), std::string(which) + ": " + e.what());
    }
}

Couple coupleOf(const State& state, BodyId a, BodyId b) {
    const Couple both{indexOfEnd(state, a, "the first body"),
                      indexOfEnd(state, b, "the second body")};
    if (a == b)
        throw Error(ErrorCode::degenerate,
                    "a mechanism between a body and itself; allowed are two bodies");
    const auto moves = [&](std::uint32_t i) { return state.bodies[i].kind == BodyKind::dynamic; };
    if (!moves(both.a) && !moves(both.b))
        throw Error(ErrorCode::degenerate,
                    "a mechanism between two bodies that physics does not move; at least one must "
                    "be dynamic");
    return both;
}

/// How large a body is, m.
double sizeOf(const State& state, std::uint32_t body) {
    const auto& record = state.bodies[body];
    Vec2 low = state.particles.rest[record.firstParticle], high = low;
    for (std::uint32_t k = 0; k < record.particles.size(); ++k) {
        const Vec2& rest = state.particles.rest[record.firstParticle + k];
        low = low.cwiseMin(rest);
        high = high.cwiseMax(rest);
    }
    return static_cast<double>((high - low).norm());
}

/// A point of a body, which is given in the world.
struct Found {
    MechanismPoint point;
    Vec2 local{0, 0};
    bool isParticle = false;  // it is the first support
    bool holds = true;        // the particles can hold a point there
};

/// The particle of a body that is nearest to a point.
std::uint32_t nearestParticle(const State& state, std::uint32_t body, const Point& at) {
    const auto& record = state.bodies[body];
    const auto& position = state.particles.position;
    std::uint32_t nearest = record.firstParticle;
    for (std::uint32_t i = nearest; i < record.firstParticle + record.particles.size(); ++i)
        if ((position[i] - at).squaredNorm() < (position[nearest] - at).squaredNorm()) nearest = i;
    return nearest;
}

Found find(const State& state, std::uint32_t body, const Point& at, const Pose& pose) {
    detail::requireWithin(at, detail::maxCoordinate, "point");
    const auto& rest = state.particles.rest;
    const double near = 1e-4 * (sizeOf(state, body) + 1e-3);
    Found found;
    found.local =
        detail::turnedBack(detail::unitVector(pose.angle), at - pose.position).cast<Real>();
    // Where a soft body has bent, a particle is not where its pose has it.
    const std::uint32_t nearest = nearestParticle(state, body, at);
    if ((state.particles.position[nearest] - at).norm() <= near) found.local = rest[nearest];
    const detail::Attachment held = detail::supportsFor(state, body, found.local);
    const Vec2 first = rest[held.support[0]];
    found.isParticle = static_cast<double>((first - found.local).norm()) <= near;
    if (found.isParticle) {
        found.local = first;
        found.point.count = 1;
        found.point.support[0] = state.particles.id[held.support[0]];
        found.point.weight[0] = 1;
        return found;
    }
    Vec2 reached(0, 0);
    found.point.count = held.count;
    for (std::uint32_t k = 0; k < held.count; ++k) {
        found.point.support[k] = state.particles.id[held.support[k]];
        found.point.weight[k] = held.weight[k];
        reached += held.weight[k] * rest[held.support[k]];
        found.holds &= std::abs(static_cast<double>(held.weight[k])) <= detail::farthestSupport;
    }
    found.holds &= static_cast<double>((reached - found.local).norm()) <= near;
    return found;
}

[[noreturn]] void refusePoint(const char* which) {
    throw Error(ErrorCode::degenerate,
                std::string("the particles of ") + which +
                    " cannot hold that point; allowed are places of its particles (of a ball: its "
                    "centre), on the line between two of them, or within some fifty sizes of a "
                    "body that is no line");
}

/// The line that shows how a body turns: from the particle nearest to a point to the farthest one
/// to which a joint of the body leads from there.
MechanismArm armOf(const State& state, std::uint32_t body, const Vec2& local) {
    const auto& record = state.bodies[body];
    const auto& rest = state.particles.rest;
    std::uint32_t from = record.firstParticle;
    for (std::uint32_t i = from; i < record.firstParticle + record.particles.size(); ++i)
        if ((rest[i] - local).squaredNorm() < (rest[from] - local).squaredNorm()) from = i;
    std::uint32_t to = from;
    const auto lengthTo = [&](std::uint32_t i) { return (rest[i] - rest[from]).squaredNorm(); };
    for (const JointId id : record.joints) {
        const auto j = state.jointSlots.dense(id);
        for (const auto& [one, other] : {std::pair(state.joints.a[j], state.joints.b[j]),
                                         std::pair(state.joints.b[j], state.joints.a[j])})
            if (one == from && lengthTo(other) > lengthTo(to)) to = other;
    }
    return {state.particles.id[from], state.particles.id[to]};
}

/// Adds mechanisms: what several calls of World make together goes again if one of them throws.
class MechanismMaker {
public:
    MechanismMaker(World& world, State& state, BodyId a, BodyId b)
        : world_(world), state_(state), couple_(coupleOf(state_, a, b)) {
        m_.a = a;
        m_.b = b;
        detail::makeRoom(state_.mechanisms.list, 1);
        state_.mechanisms.slots.makeRoom(1);
        // Rigid components may be derived first, so that coordinates are those that steps see.
        poseA_ = world.pose(a);
        poseB_ = world.pose(b);
    }
    MechanismMaker(const MechanismMaker&) = delete;
    MechanismMaker& operator=(const MechanismMaker&) = delete;
    /// What was made for a mechanism that is not made goes again. Where there is no memory even for
    /// that, a pin stays that holds at most one body.
    ~MechanismMaker() {
        if (done_) return;
        if (m_.vetoes != 0) std::erase(state_.vetoes, detail::BodyPair::of(m_.a, m_.b));
        try {
            for (const BodyId own : m_.own)
                if (own) detail::removeBody(state_, state_.bodySlots.dense(own));
        } catch (const std::bad_alloc&) {
        }
    }

    Found a(const Point& at) const { return find(state_, couple_.a, at, poseA_); }
    Found b(const Point& at) const { return find(state_, couple_.b, at, poseB_); }

    /// Joins both bodies at a point, by a particle of theirs or a pin. `collide`: as in options;
    /// an attachment of a body's own particle cannot be taken back, and so comes last.
    void addPin(const Point& at, bool collide) {
        const Found onA = a(at), onB = b(at);
        const bool byB = onB.isParticle && onA.holds && moves(couple_.b);
        const bool byA = onA.isParticle && onB.holds && moves(couple_.a);
        // What stands still holds any point, by a body of its own there.
        const bool fixedA = state_.bodies[couple_.a].kind == BodyKind::fixed,
                   fixedB = state_.bodies[couple_.b].kind == BodyKind::fixed;
        if (!byA && !byB && !fixedA && !onA.holds) refusePoint("the first body");
        if (!byA && !byB && !fixedB && !onB.holds) refusePoint("the second body");
        setCollision(collide);
        if (byB) return attach(0, onB.point.support[0], m_.a, onA.local);
        if (byA) return attach(0, onA.point.support[0], m_.b, onB.local);
        const ParticleId pin =
            addOwn(at, fixedA || fixedB ? BodyKind::fixed : BodyKind::dynamic, pinMass());
        if (fixedA || fixedB) {
            const Found& other = fixedA ? onB : onA;
            if (other.isParticle) return attach(0, other.point.support[0], m_.own[0], {0, 0});
            return attach(0, pin, fixedA ? m_.b : m_.a, other.local);
        }
        attach(0, pin, m_.a, onA.local);
        attach(1, pin, m_.b, onB.local);
    }

    void addArms(const Point& at) {
        m_.arms = {armOf(state_, couple_.a, a(at).local), armOf(state_, couple_.b, b(at).local)};
    }

    /// Of a body (dense). What stands still holds any point, by a body of its own there.
    void addPoint(std::size_t k, std::uint32_t body, const Point& at, const char* which) {
        const Found found = find(state_, body, at, world_.pose(state_.bodies[body].id));
        m_.points[k] = found.point;
        if (found.holds) return;
        if (state_.bodies[body].kind != BodyKind::fixed) refusePoint(which);
        m_.points[k] = {};
        m_.points[k].count = 1;
        m_.points[k].weight[0] = 1;
        m_.points[k].support[0] = addOwn(at, BodyKind::fixed, 1);
    }
    void addPointOfA(std::size_t k, const Point& at) {
        addPoint(k, couple_.a, at, "the first body");
    }
    void addPointOfB(std::size_t k, const Point& at) {
        addPoint(k, couple_.b, at, "the second body");
    }

    /// Puts it on the link of its rail that is nearest to a point, where its own point is. Throws
    /// unless the rail is one.
    void takeRail(const Point& at);

    void setCollision(bool collide) {
        m_.apart = collide ? 0 : 1;
        if (collide || !world_.collision(m_.a, m_.b)) return;
        world_.setCollision(m_.a, m_.b, false);
        m_.vetoes = 1;
    }

    /// Nothing of this fails.
    MechanismId finish() {
        auto& all = state_.mechanisms;
        m_.id = all.slots.insert(static_cast<std::uint32_t>(all.list.size()));
        all.list.push_back(std::move(m_));
        done_ = true;
        detail::wakeBoth(state_, all.list.back());
        detail::bodyChanged(state_);
        return all.list.back().id;
    }

    Mechanism& mechanism() { return m_; }
    const State& state() const { return state_; }
    double sizeOfA() const { return sizeOf(state_, couple_.a); }

private:
    bool moves(std::uint32_t body) const { return state_.bodies[body].kind == BodyKind::dynamic; }
    /// A real pin is light beside what it holds.
    Real pinMass() const {
        double least = detail::maxMass;
        for (const auto body : {couple_.a, couple_.b})
            if (moves(body))
                least = std::min(least, static_cast<double>(detail::movableMass(state_, body)));
        return static_cast<Real>(std::max(detail::tuned::pinShare * least, detail::minMass));
    }
    ParticleId addOwn(const Point& at, BodyKind kind, Real mass) {
        Blueprint plan{.name = "pin"};
        plan.kind = kind;
        plan.particles.push_back({.position = {0, 0}, .mass = mass});
        BodyId& own = m_.own[0] ? m_.own[1] : m_.own[0];
        own = world_.add(plan, {.position = at});
        return world_.particles(own).front();
    }
    void attach(std::size_t k, ParticleId particle, BodyId body, const Vec2& local) {
        m_.pins[k] = world_.attach(particle, body, local);
    }

    World& world_;
    State& state_;
    Couple couple_;
    Pose poseA_, poseB_;
    Mechanism m_;
    bool done_ = false;
};

void MechanismMaker::takeRail(const Point& at) {
    const std::vector<std::uint32_t> rail = detail::railOf(state_, couple_.a, m_.rail.links);
    const std::vector<std::uint32_t> nodes = detail::nodesOfRail(state_, rail);
    const auto& particles = state_.particles;
    m_.rail.closed = rail.size() > 1 && nodes.front() == nodes.back() ? 1 : 0;
    std::uint32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity(), length = 0, begin = 0;
    for (std::uint32_t k = 0; k < rail.size(); ++k) {
        putOnLink(state_, m_, k, particles.id[nodes[k]]);
        const detail::OnRail on = onRail(state_, m_, false);
        double apart = std::abs(on.off);
        if (on.place < 0) apart = (particles.position[nodes[k]] - at).norm();
        if (on.place > on.length) apart = (particles.position[nodes[k + 1]] - at).norm();
        if (apart + tied * on.length < least) {
            least = apart;
            nearest = k;
            begin = length;
        }
        length += on.length;
    }
    if (!(least <= length / 2))
        throw Error(ErrorCode::degenerate,
                    "slider: the point is " + std::to_string(least) +
                        " m beside the rail; allowed is half of the rail's length, " +
                        std::to_string(length / 2) + " m");
    m_.rail.begin = begin;
    putOnLink(state_, m_, nearest, particles.id[nodes[nearest]]);
}

}  // namespace

MechanismId World::hinge(BodyId a, BodyId b, Point at, const HingeOptions& options) {
    detail::validate(options.drive);
    detail::requireStrength(options.strength, "hinge: strength");
    detail::requireRange(options.value, -farthestValue, farthestValue, "hinge: value");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::hinge;
    m.drive = options.drive;
    m.pinStrength = options.strength;
    maker.addArms(at);
    if (options.pin)
        maker.addPin(at, options.collide);
    else
        maker.setCollision(options.collide);
    m.zero = valueOf(maker.state(), m, RowOf::drive, false) - options.value;
    return maker.finish();
}

MechanismId World::weld(BodyId a, BodyId b, Point at, const WeldOptions& options) {
    Drive drive;
    drive.stiffness = options.stiffness;
    drive.damping = options.damping;
    drive.strength = options.torqueStrength;
    detail::validate(drive);
    detail::requireStrength(options.strength, "weld: strength");
    detail::requireRange(options.value, -farthestValue, farthestValue, "weld: value");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::weld;
    m.drive = drive;
    m.pinStrength = options.strength;
    maker.addArms(at);
    maker.addPin(at, options.collide);
    m.zero = valueOf(maker.state(), m, RowOf::drive, false) - options.value;
    return maker.finish();
}

MechanismId World::slider(BodyId a, BodyId b, Point at, Vec2 axis, const SliderOptions& options) {
    detail::validate(options.drive);
    detail::requireRange(options.value, -farthestValue, farthestValue, "slider: value");
    detail::requireFinite(axis, "slider: axis");
    const double length = axis.cast<double>().norm();
    if (!(length > 0))
        throw Error(ErrorCode::degenerate, "slider: the axis is zero; allowed is any other vector");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::slider;
    m.drive = options.drive;
    m.turns = options.turns ? 1 : 0;
    const double size = std::max(maker.sizeOfA(), 1e-3);
    const Point end = at + size / length * axis.cast<double>();
    maker.addPointOfB(0, at);
    maker.addPointOfA(1, at);
    maker.addPointOfA(2, end);
    if (!options.turns) {
        maker.addArms(at);
        m.zeroAngle = valueOf(maker.state(), m, RowOf::angle, false);
    }
    m.zero = valueOf(maker.state(), m, RowOf::drive, false) - options.value;
    maker.setCollision(options.collide);
    return maker.finish();
}

MechanismId World::slider(BodyId a, BodyId b, Point at, std::span<const JointId> rail,
                          const SliderOptions& options) {
    detail::validate(options.drive);
    detail::requireRange(options.value, -farthestValue, farthestValue, "slider: value");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::slider;
    m.drive = options.drive;
    m.turns = options.turns ? 1 : 0;
    m.zero = -options.value;
    m.rail.links.assign(rail.begin(), rail.end());  // before bodies are added, which may have it
    maker.addPointOfB(0, at);
    maker.takeRail(at);
    if (!options.turns) {
        maker.addArms(at);
        m.zeroAngle = valueOf(maker.state(), m, RowOf::angle, false);
    }
    maker.setCollision(options.collide);
    return maker.finish();
}

WheelIds World::wheel(BodyId body, BodyId wheel, Point at, Vec2 axis, const WheelOptions& options) {
    detail::validate(options.spring);
    detail::validate(options.motor);
    WheelIds ids;
    ids.spring =
        slider(body, wheel, at, axis, {.drive = options.spring, .collide = options.collide});
    try {
        ids.motor = hinge(body, wheel, at, {.drive = options.motor, .collide = true, .pin = false});
    } catch (...) {
        remove(ids.spring);
        throw;
    }
    return ids;
}

MechanismId World::distance(BodyId a, Point atA, BodyId b, Point atB,
                            const DistanceOptions& options) {
    detail::validate(options.drive);
    if (!(options.drive.upper > 0))
        throw Error(ErrorCode::outOfRange,
                    "distance: the upper limit is " +
                        std::to_string(static_cast<double>(options.drive.upper)) +
                        "; allowed is more than 0, and a hinge for points that meet");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::distance;
    m.drive = options.drive;
    maker.addPointOfA(0, atA);
    maker.addPointOfB(1, atB);
    maker.setCollision(options.collide);
    return maker.finish();
}

MechanismId World::pulley(BodyId a, Point atA, Point overA, BodyId b, Point atB, Point overB,
                          BodyId frame, const PulleyOptions& options) {
    detail::requireRange(static_cast<double>(options.ratio), 1e-6, 1e6, "pulley: ratio");
    detail::requireStrength(options.strength, "pulley: strength");
    if (options.length)
        detail::requireRange(static_cast<double>(*options.length), 0, detail::maxCoordinate,
                             "pulley: length");
    MechanismMaker maker(*this, impl_->changing(), a, b);
    const State& state = maker.state();
    const auto holder = indexOfEnd(state, frame, "the frame");
    Mechanism& m = maker.mechanism();
    m.kind = MechanismKind::pulley;
    m.ratio = options.ratio;
    m.frame = frame;
    maker.addPoint(0, holder, overA, "the frame");
    maker.addPointOfA(1, atA);
    maker.addPoint(2, holder, overB, "the frame");
    maker.addPointOfB(3, atB);
    const double whole = valueOf(state, m, RowOf::drive, false);
    m.drive.upper = options.length.value_or(static_cast<Real>(whole));
    m.drive.strength = options.strength;
    return maker.finish();
}

MechanismId World::gear(MechanismId first, MechanismId second, Real ratio) {
    State& state = impl_->changing();
    detail::requireFinite(static_cast<double>(ratio), "gear: ratio");
    if (std::abs(static_cast<double>(ratio)) < 1e-6 || std::abs(static_cast<double>(ratio)) > 1e6)
        throw Error(ErrorCode::outOfRange, "gear: ratio is " +
                                               std::to_string(static_cast<double>(ratio)) +
                                               "; allowed is 1e-6 to 1e6, or the same below 0");
    Mechanism m;
    m.kind = MechanismKind::gear;
    for (const MechanismId part : {first, second})
        if (detail::knownMechanism(state, part).kind == MechanismKind::gear)
            throw Error(ErrorCode::degenerate,
                        "gear: a part is a gear; allowed are all other mechanisms");
    if (first == second)
        throw Error(ErrorCode::degenerate,
                    "gear: both parts are one mechanism; allowed are two of them");
    m.parts = {first, second};
    m.a = detail::knownMechanism(state, first).b;
    m.b = detail::knownMechanism(state, second).b;
    m.ratio = ratio;
    m.drive.stiffness = infinite;
    auto& all = state.mechanisms;
    detail::makeRoom(all.list, 1);
    all.slots.makeRoom(1);
    m.zero = valueOf(state, m, RowOf::drive, false);
    m.id = all.slots.insert(static_cast<std::uint32_t>(all.list.size()));
    all.list.push_back(m);
    detail::wakeBoth(state, m);
    detail::bodyChanged(state);
    return m.id;
}

}  // namespace sulfur
