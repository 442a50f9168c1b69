// Ropes over the edges of crates, with loads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "battery/contacts/contacts.hpp"
#include "battery/contacts/stage.hpp"
#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr double ropeMass = 0.5, ropeRadius = 0.015, link = 0.05;  // kg, m, m
constexpr double clear = ropeRadius + 0.005;  // m, of the rope's axis from a surface at first

/// A rope of rigid links of about 5 cm along a broken line, with a particle at each corner. The
/// last particle has `load` kg.
Blueprint ropeAlong(const std::vector<Point>& corners, bool pinFirst, double load) {
    Blueprint plan;
    plan.name = "rope";
    plan.particles.push_back({.position = corners.front().cast<Real>(), .pinned = pinFirst});
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Point way = corners[i + 1] - corners[i];
        const int links = std::max(1, static_cast<int>(std::lround(way.norm() / link)));
        for (int j = 1; j <= links; ++j)
            plan.particles.push_back({.position = (corners[i] + way * j / links).cast<Real>()});
    }
    for (ParticleSpec& p : plan.particles)
        p.mass = real(ropeMass / static_cast<double>(plan.particles.size()));
    if (load > 0) plan.particles.back().mass = real(load);
    for (std::uint32_t i = 0; i + 1 < plan.particles.size(); ++i)
        plan.joints.push_back({.a = i, .b = i + 1, .radius = real(ropeRadius)});
    return plan;
}

/// A rope over a crate and what it carries, watched for 20 s.
struct Hanging {
    std::string name, picture;
    Body rope, crate;                           // the crate is what the rope lies on
    std::vector<Body> loads = {};               // none: the rope's last particle is the load
    double wayReached = 0;                      // m, where more than what was asked
};

Rows hang(World& world, const Hanging& h, const Setup& setup) {
    const auto loadPlace = [&] {
        return h.loads.empty() ? world.position(h.rope.back()) : world.centreOfMass(h.loads.back());
    };
    const Point start = loadPlace(), crateStart = world.centreOfMass(h.crate);
    double deep = 0, stretch = 0, bent = 0;
    for (int i = 0; i < 20 * setup.tickRate; ++i) {
        world.step();
        if (i % 5 != 0) continue;
        deep = worst(deep, overlapOf(world, h.rope.id(), h.crate.id()));
        stretch = worst(stretch, largestStrain(world, h.rope));
        bent = worst(bent, largestStrain(world, h.crate));
    }
    keepPicture(setup, h.picture, world);
    const double way = (loadPlace() - start).norm();
    constexpr double wayAsked = 0.1;  // m
    const std::string wayOfLoad = h.name + "way of the load in 20 s (m)";
    return {h.wayReached > wayAsked ? fallsShort(wayOfLoad, way, h.wayReached, wayAsked)
                                    : atMost(wayOfLoad, way, wayAsked),
            atMost(h.name + "deepest overlap of rope and crate (m)", deep, ropeRadius / 2),
            atMost(h.name + "way of the crate under the rope (m)",
                   (world.centreOfMass(h.crate) - crateStart).norm(), 0.01),
            atMost(h.name + "distortion of the crate (share)", bent, 1e-3),
            atMost(h.name + "stretch of a link (share)", stretch, 0.02)};
}

/// Pinned behind a crate, over its top and down its front.
Rows overEdge(double load, const Setup& setup) {
    World world(still(setup, standardGravity));
    addFloor(world, 5);
    const Body block = world.add(crate({.mass = 500}), {.position = Point(0, 0.5)});
    const double top = 1 + clear, front = 0.5 + clear;
    const Body rope = world.add(
        ropeAlong({Point(-1, top), Point(front, top), Point(front, top - 0.6)}, true, load));
    return hang(
        world,
        {.name = fmt::format("rope of 0.5 kg over the edge of a crate, load {:g} kg: ", load),
         .picture = fmt::format("rope-over-edge-{:g}", load),
         .rope = rope,
         .crate = block},
        setup);
}

/// A crate of `mass` kg that hangs by both ends of a rope which lies over a fixed beam. Rope and
/// crate are a ring.
Rows sling(double mass, const Setup& setup) {
    World world(still(setup, standardGravity));
    Blueprint fixedBeam = crate({.size = 0.3});
    fixedBeam.kind = BodyKind::fixed;
    const Body beam = world.add(fixedBeam, {.position = Point(0, 3)});
    const Body load = world.add(crate({.mass = mass}), {.position = Point(0, 1)});
    const double side = 0.15 + clear, top = 3 + side, corner = 0.48;
    const Body rope = world.add(ropeAlong({Point(-corner, 1 + corner), Point(-side, top),
                                           Point(side, top), Point(corner, 1 + corner)},
                                          false, 0));
    world.attach(rope.front(), load, vec2(-corner, corner));
    world.attach(rope.back(), load, vec2(corner, corner));
    return hang(
        world,
        {.name = fmt::format("rope of 0.5 kg that carries a crate of {:g} kg from a beam: ", mass),
         .picture = fmt::format("rope-sling-{:g}", mass),
         .rope = rope,
         .crate = beam,
         .loads = {load}},
        setup);
}

/// Two crates on a rope over a fixed crate, which friction at its two edges holds.
struct Atwood {
    Atwood(const Setup& setup, double left, double right) : world(still(setup, standardGravity)) {
        Blueprint fixedBlock = crate();
        fixedBlock.kind = BodyKind::fixed;
        block = world.add(fixedBlock, {.position = Point(0, 4)});
        const double side = 0.5 + clear, top = 4.5 + clear, low = 2.5;
        const double inside = 0.23;  // m, of the place that holds, from the crate's middle
        rope = world.add(ropeAlong(
            {Point(-side, low), Point(-side, top), Point(side, top), Point(side, low)}, false, 0));
        for (const double sign : {-1.0, 1.0}) {
            const double mass = sign < 0 ? left : right;
            loads.push_back(world.add(crate({.size = 0.5, .mass = mass}),
                                      {.position = Point(sign * side, low - inside)}));
            world.attach(sign < 0 ? rope.front() : rope.back(), loads.back(), vec2(0, inside));
        }
    }

    World world;
    Body block, rope;
    std::vector<Body> loads;
};

Rows joined(double left, double right, const Setup& setup) {
    Atwood a(setup, left, right);
    return hang(a.world,
                {.name = fmt::format(
                     "rope over a fixed crate between crates of {:g} and {:g} kg: ", left, right),
                 .picture = fmt::format("rope-joins-{:g}-{:g}", left, right),
                 .rope = a.rope,
                 .crate = a.block,
                 .loads = a.loads,
                 .wayReached = left != right ? 0.2 : 0.0},
                setup);
}

/// What friction does not hold (its limit is e^(pi mu), 6.6 here) slides over the edges.
Rows slides(const Setup& setup) {
    Atwood a(setup, 5, 100);
    double deep = 0;
    const Point start = a.world.centreOfMass(a.loads.back());
    for (int i = 0; i < setup.tickRate / 2; ++i) {
        a.world.step();
        deep = worst(deep, overlapOf(a.world, a.rope.id(), a.block.id()));
    }
    const double way = start.y() - a.world.centreOfMass(a.loads.back()).y();
    keepPicture(setup, "rope-slides", a.world);
    const std::string name = "rope over a fixed crate between crates of 5 and 100 kg, 0.5 s: ";
    return {atMost(name + "deepest overlap of rope and crate (m)", deep, ropeRadius / 2),
            atMost(name + "does not slide by 0.1 m", way > 0.1 ? 0 : 1, 0),
            reported(name + "way of the heavier one (m)", way)};
}

// --- a rope over a round peg --------------------------------------------------------------------

constexpr double pegRadius = 0.3, pegFriction = 0.3;  // m; static and kinetic
constexpr int halfOfRope = 40;                        // links

/// A rope over the upper half of a peg at the origin, which its links touch in their middles.
struct OverPeg {
    double linkMass, load;  // kg; the latter at the back end

    double turn() const {
        return 2 * std::asin(link / 2 / std::hypot(pegRadius + ropeRadius, link / 2));
    }
    int onPeg() const { return static_cast<int>(std::acos(-1) / 2 / turn()); }  // links of a side
    /// kg: that of its end and of the links that hang.
    double back() const { return load + (halfOfRope - onPeg() - 1) * linkMass; }

    /// At which ratio of `front` to back() it slips: Euler's law, with the weight of what lies on
    /// the peg, which presses and has to be lifted.
    double slipsAt() const {
        const double bears = std::exp(pegFriction * std::acos(-1));
        const double lies = linkMass / turn() / back();  // 1/rad
        return bears + 2 * pegFriction / (1 + pegFriction * pegFriction) * lies * (bears + 1);
    }

    /// `front`: kg, as back().
    Blueprint plan(double front) const {
        const double around = std::hypot(pegRadius + ropeRadius, link / 2);
        const double quarter = onPeg() * turn();
        Blueprint rope;
        rope.material = {.staticFriction = real(pegFriction), .kineticFriction = real(pegFriction)};
        for (int i = -halfOfRope; i <= halfOfRope; ++i) {
            const double angle = std::abs(i) * turn(), on = std::min(angle, quarter);
            const double hangs = (angle - on) / turn() * link;
            rope.particles.push_back({.position = vec2(std::copysign(around * std::sin(on), i),
                                                       around * std::cos(on) - hangs),
                                      .mass = real(linkMass)});
        }
        rope.particles.front().mass = real(front - back() + load);
        rope.particles.back().mass = real(load);
        for (std::uint32_t i = 0; i < 2 * halfOfRope; ++i)
            rope.joints.push_back({.a = i, .b = i + 1, .radius = real(ropeRadius)});
        return rope;
    }
};

/// Whether the front end moves by more than 1 cm in the second half of a second.
bool slips(const OverPeg& scene, double front, const Setup& setup) {
    World world(still(setup, standardGravity));
    Blueprint peg;
    peg.kind = BodyKind::fixed;
    peg.material = {.staticFriction = real(pegFriction), .kineticFriction = real(pegFriction)};
    peg.particles.push_back({.position = {0, 0}, .radius = real(pegRadius)});
    world.add(peg);
    const Body rope = world.add(scene.plan(front));
    double before = 0;
    for (int i = 0; i < setup.tickRate; ++i) {
        if (i == setup.tickRate / 2) before = world.position(rope.front()).y();
        world.step();
    }
    return !(std::abs(before - world.position(rope.front()).y()) < 0.01);
}

/// The heavier the loads are than the links, the sooner a rope slips.
Rows overPeg(const Setup& setup) {
    Rows rows;
    for (const double linkMass : {0.001, 0.01, 0.1})
        for (const double load : {1.0, 10.0}) {
            const OverPeg scene{linkMass, load};
            double holds = 1, lets = 2 * scene.slipsAt();  // ratios
            for (int k = 0; k < 10; ++k) {
                const double ratio = std::sqrt(holds * lets);
                (slips(scene, ratio * scene.back(), setup) ? lets : holds) = ratio;
            }
            const std::string name = fmt::format(
                "rope with links of {:g} kg over a peg, load {:g} kg: error of the ratio at which "
                "it slips (share)",
                linkMass, load);
            rows.push_back(fallsShort(name, std::abs(holds / scene.slipsAt() - 1),
                                      load / linkMass < 5000 ? 0.15 : 0.4, 0.05));
        }
    return rows;
}

}  // namespace

Rows ropesOverEdges(const Setup& setup) {
    Rows rows;
    for (Rows more : {overEdge(5, setup), overEdge(50, setup), sling(2, setup), sling(50, setup),
                      joined(50, 50, setup), joined(50, 60, setup), slides(setup), overPeg(setup)})
        for (Row& row : more) rows.push_back(std::move(row));
    return rows;
}

}  // namespace sulfur::lab
