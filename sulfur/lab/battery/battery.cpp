#include "battery/battery.hpp"

#include "battery/contacts/contacts.hpp"
#include "battery/fall.hpp"
#include "battery/hanging.hpp"
#include "battery/joints/joints.hpp"
#include "battery/nets.hpp"
#include "battery/pendulums.hpp"
#include "battery/random_worlds.hpp"
#include "battery/refusals.hpp"
#include "battery/rope_release.hpp"
#include "battery/scenes.hpp"
#include "battery/soft_bodies.hpp"
#include "battery/spinning.hpp"
#include "battery/springs.hpp"

namespace sulfur::lab {

namespace {

void append(Rows& rows, Rows more) {
    rows.insert(rows.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
}

Rows fall(const Setup& setup) {
    Rows rows;
    for (const int rate : {60, 120, 500, 2000, 10000})
        for (const double distance : {0.0, 100.0, 1000.0})
            rows.push_back(freeFall(distance, {rate, setup.sweeps}));
    for (const int rate : {500, 10000}) rows.push_back(slowDrift(10, {rate, setup.sweeps}));
    return rows;
}

Rows springs(const Setup& whole) {
    const Setup setup = whole.ofSteps();
    Rows rows;
    for (const double share : {0.01, 0.1, 0.5, 0.999})
        append(rows, undampedSpring(share * explicitRange(setup), 100, setup));
    rows.push_back(dampedSpring(100, 0.2, setup));
    rows.push_back(dampedSpring(100, 2, setup));
    rows.push_back(dampedSpring(1e4, 2, setup));
    rows.push_back(dampedSpring(1e4, 20, setup));
    return rows;
}

Rows seamless(const Setup& whole) {
    const Setup setup = whole.ofSteps();
    Rows rows;
    for (const double damping : {0.0, 1.0, 20.0})
        append(rows, seamlessStiffness(damping, 200, setup));
    return rows;
}

Rows pendulums(const Setup& setup) {
    Rows rows = pendulum(60, setup);
    for (const Vec2& size : {vec2(1, 1), vec2(0.3, 1)})
        for (const Hinge hinge : {Hinge::corner, Hinge::top})
            rows.push_back(solidPendulum(size, hinge, setup));
    return rows;
}

Rows spinning(const Setup& setup) {
    Rows rows;
    for (const double distance : {0.0, 1000.0})
        for (const double turns : {1.0, 5.0, 10.0})
            append(rows, spinningCrate(turns, distance, 60, setup));
    for (const double turns : {1.0, 5.0, 10.0, 50.0})
        append(rows, fastCrate(turns, 60, {60, setup.sweeps}));
    for (const int rate : {60, 500})
        for (const double speed : {10.0, 100.0, 1000.0})
            append(rows, spinningShard(speed, 10, {rate, setup.sweeps}));
    return rows;
}

Rows soft(const Setup& setup) {
    Rows rows = freeSoftBody(1'000'000, setup);
    for (const double disorder : {0.3, 0.5, 2.0})
        for (const std::uint64_t seed : {1u, 2u, 3u})
            append(rows, scrambledLattice(disorder, seed, setup));
    return rows;
}

Rows hanging(const Setup& setup) {
    Rows rows{hangingBetweenPins(setup)};
    for (const double stiffness : {1e3, 1e5, 1e7})
        rows.push_back(hangingStretched(stiffness, setup));
    for (const int mode : {1, 2, 3}) rows.push_back(swingFrequency(mode, setup));
    rows.push_back(alternatingSprings(setup));
    return rows;
}

Rows ropes(const Setup& setup) {
    Rows rows;
    for (const double length : {0.05, 0.25}) {
        for (const double load : {1.0, 10.0, 100.0, 1e3, 1e4})
            append(rows, releaseRope({.linkLength = length, .load = load}, setup));
        append(rows,
               releaseRope(
                   {.linkLength = length, .load = 1e6, .stretchBound = 1e-3, .accurate = false},
                   setup));
        append(rows, releaseRope({.linkLength = length,
                                  .load = 100,
                                  .links = 1000,
                                  .stretchBound = 1e-3,
                                  .accurate = false},
                                 setup));
    }
    return rows;
}

}  // namespace

const std::vector<BatteryGroup>& batteryGroups() {
    static const std::vector<BatteryGroup> all{
        {"fall", "free fall and drift", fall},
        {"springs", "springs, undamped and damped", springs},
        {"seamless", "stiffness from soft to rigid", seamless},
        {"pendulums", "pendulums and solid bodies on a hinge", pendulums},
        {"spinning", "rigid bodies in free flight", spinning},
        {"soft", "soft bodies", soft},
        {"hanging", "hanging chains", hanging},
        {"ropes", "ropes with a load, released horizontally", ropes},
        {"nets", "nets and frames under loads", nets},
        {"lattices", "random lattices",
         [](const Setup& setup) { return randomLattices(RandomLattices::all(), setup); }},
        {"joints", "wheels, hinges and other mechanisms", joints},
        {"contacts-inclines", "a crate on a slope", inclines},
        {"contacts-rebounds", "a disc that bounces", rebounds},
        {"contacts-stacks", "crates one on another", stacks},
        {"contacts-pyramids", "pyramids of crates", pyramids},
        {"contacts-arches", "an arch and a house of cards", arches},
        {"contacts-weights", "weight at the floor", weights},
        {"contacts-ropes", "loaded ropes over edges", ropesOverEdges},
        {"contacts-overlaps", "bodies that start in each other", overlaps},
        {"contacts-impulses", "equal impulses on soft and rigid bodies", impulses},
        {"contacts-seams", "sliding over seams", seams},
        {"contacts-segments", "segments on a floor of segments", segments},
        {"contacts-shots", "random shots at up to 300 m/s", shots},
        {"contacts-crowds", "a thousand bodies", crowds},
        {"contacts-crumbling", "a wall that breaks", crumbling},
        {"random", "random worlds and the laws that they keep", randomWorlds, true},
        {"nonsense", "what a caller may not pass", [](const Setup&) { return refusals(); }},
    };
    return all;
}

}  // namespace sulfur::lab
