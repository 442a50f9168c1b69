#include "battery/refusals.hpp"

#include <functional>
#include <limits>

#include "battery/measure.hpp"
#include "battery/scenes.hpp"

namespace sulfur::lab {

namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

Blueprint pair() {
    Blueprint plan = ghost("pair");
    plan.particles = {{.position = {0, 0}}, {.position = {1, 0}}};
    plan.joints = {{.a = 0, .b = 1, .stiffness = 100}};
    return plan;
}

/// What may happen to a call.
enum class Allowed {
    refusal,  ///< it must throw
    noOp,     ///< it may also do nothing that changes or breaks the world
    use,      ///< it may also be obeyed; the world must then go on soundly
};

bool wellBehaved(Allowed allowed, const std::function<void(World&, Body)>& call) {
    World world(still({}, standardGravity));
    const Body body = world.add(pair());
    run(world, 0.1);
    const auto before = world.hash();
    try {
        call(world, body);
    } catch (const Error&) {
        return world.hash() == before && world.validate().empty();
    }
    if (allowed == Allowed::refusal) return false;
    if (allowed == Allowed::noOp && world.hash() != before) return false;
    run(world, 1);
    for (const BodyId id : world.bodies())
        if (!allFinite(world, world.particles(id))) return false;
    return world.validate().empty();
}

/// Adds a pair that `change` has made nonsense of.
std::function<void(World&, Body)> adding(std::function<void(Blueprint&)> change) {
    return [change = std::move(change)](World& world, Body) {
        Blueprint plan = pair();
        change(plan);
        world.add(plan);
    };
}

struct Case {
    const char* name;
    Allowed allowed;
    std::function<void(World&, Body)> call;
};

std::vector<Case> geometry() {
    return {
        {"rigid joint of zero length", Allowed::refusal, adding([](Blueprint& p) {
             p.joints[0].stiffness = infinite;
             p.joints[0].restLength = Real(0);
         })},
        {"elastic joint of zero length", Allowed::use,
         adding([](Blueprint& p) { p.joints[0].restLength = Real(0); })},
        {"joint from a particle to itself", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].b = 0; })},
        {"joint to a particle that is not there", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].b = 9; })},
        {"the same joint twice", Allowed::use,
         adding([](Blueprint& p) { p.joints.push_back(p.joints[0]); })},
        {"the same rigid joint twice", Allowed::use, adding([](Blueprint& p) {
             p.joints[0].stiffness = infinite;
             p.joints.push_back(p.joints[0]);
         })},
        {"coincident particles with a spring", Allowed::use, adding([](Blueprint& p) {
             p.particles[1].position = p.particles[0].position;
             p.joints[0].restLength = Real(1);
         })},
        {"coincident particles with a rigid joint of 1 m", Allowed::use, adding([](Blueprint& p) {
             p.particles[1].position = p.particles[0].position;
             p.joints[0].restLength = Real(1);
             p.joints[0].stiffness = infinite;
         })},
        {"joint between two pinned particles", Allowed::use, adding([](Blueprint& p) {
             p.particles[0].pinned = p.particles[1].pinned = true;
             p.joints[0].stiffness = infinite;
         })},
        {"connecting a particle to itself", Allowed::refusal,
         [](World& w, Body b) { w.connect(b.front(), b.front()); }},
        {"connecting two pinned particles", Allowed::use,
         [](World& w, Body b) {
             Blueprint nail = ghost("nail");
             nail.particles = {{.position = {3, 0}, .pinned = true}};
             const ParticleId first = w.add(nail).front();
             w.setPinned(b.front(), true);
             try {
                 w.connect(b.front(), first);
             } catch (const Error&) {  // The nail has changed the world, so judge it as used.
             }
         }},
    };
}

std::vector<Case> numbers() {
    return {
        {"NaN position", Allowed::refusal,
         adding([](Blueprint& p) { p.particles[0].position = Vec2(nan, 0); })},
        {"infinite position", Allowed::refusal,
         adding([](Blueprint& p) { p.particles[0].position = Vec2(0, infinite); })},
        {"negative mass", Allowed::refusal, adding([](Blueprint& p) { p.particles[0].mass = -1; })},
        {"zero mass", Allowed::refusal, adding([](Blueprint& p) { p.particles[0].mass = 0; })},
        {"NaN mass", Allowed::refusal, adding([](Blueprint& p) { p.particles[0].mass = nan; })},
        {"infinite mass", Allowed::refusal,
         adding([](Blueprint& p) { p.particles[0].mass = infinite; })},
        {"negative stiffness", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].stiffness = -1; })},
        {"NaN stiffness", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].stiffness = nan; })},
        {"negative damping", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].damping = -1; })},
        {"negative rest length", Allowed::refusal,
         adding([](Blueprint& p) { p.joints[0].restLength = Real(-1); })},
        {"no particles", Allowed::refusal, adding([](Blueprint& p) { p = ghost("none"); })},
        {"setPosition with NaN", Allowed::refusal,
         [](World& w, Body b) { w.setPosition(b.front(), Point(0, static_cast<double>(nan))); }},
        {"setVelocity with infinity", Allowed::refusal,
         [](World& w, Body b) { w.setVelocity(b.front(), Vec2(infinite, 0)); }},
        {"applyForce with NaN", Allowed::refusal,
         [](World& w, Body b) { w.applyForce(b.front(), Vec2(nan, 0)); }},
        {"applyImpulse with NaN", Allowed::refusal,
         [](World& w, Body b) { w.applyImpulse(b.front(), Vec2(nan, 0)); }},
        {"setMass with a negative one", Allowed::refusal,
         [](World& w, Body b) { w.setMass(b.front(), -1); }},
        {"setStiffness with NaN", Allowed::refusal,
         [](World& w, Body b) { w.setStiffness(b.joints().front(), nan); }},
        {"setGravity with NaN", Allowed::refusal,
         [](World& w, Body) { w.setGravity(Vec2(nan, 0)); }},
        {"a stale handle", Allowed::refusal,
         [](World& w, Body) { w.setPinned(ParticleId{.index = 99, .generation = 7}, true); }},
    };
}

}  // namespace

Rows refusals() {
    Rows rows;
    for (const auto& cases : {geometry(), numbers()})
        for (const Case& c : cases)
            rows.push_back(atMost(std::string("nonsense: ") + c.name + " (1: not handled)",
                                  wellBehaved(c.allowed, c.call) ? 0 : 1, 0));
    return rows;
}

}  // namespace sulfur::lab
