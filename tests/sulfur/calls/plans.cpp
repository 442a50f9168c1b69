// Bodies, made well and badly.
#include "calls/caller.hpp"

namespace sulfur::test {

Blueprint Caller::plan() {
    const Real s = strength();
    const std::size_t kind = numbers_->below(allowed_ == Calls::all ? 18 : 11);
    return kind < 11 ? commonPlan(kind, s) : kind < 15 ? rarePlan(s) : rawPlan();
}

Blueprint Caller::commonPlan(std::size_t kind, Real s) {
    const auto size = [&] { return static_cast<Real>(numbers_->uniform(0.15, 1.2)); };
    switch (kind) {
        case 0:
            return shapes::box({.size = {size(), size()}, .strength = s});
        case 1:
            return shapes::ball({.radius = size() / 3, .mass = positive()});
        case 2:
            return shapes::rope({.to = {0, -size()},
                                 .links = 6,
                                 .bending = oneIn(3)   ? Real(0)
                                            : oneIn(3) ? Real(100)
                                                       : Real(1),
                                 .strength = s});
        case 3:
            return shapes::chain({.to = {size(), 0}, .links = 4, .strength = s});
        case 4:
            return shapes::wheel({.radius = size() / 2, .segments = 8, .strength = s});
        case 5:
            return shapes::jelly(
                {.size = {size(), size()}, .columns = 3, .rows = 3, .strength = s});
        case 6:
            return shapes::polygon({.points = {{0, 0}, {1, 0}, {1, 1}, {Real(0.5), Real(0.3)}},
                                    .stiffness = either() ? infinite : 2000,
                                    .strength = s});
        case 7:
            return shapes::bridge({.from = {-1, 0}, .to = {1, 0}, .planks = 4, .strength = s});
        case 8: {
            const Real right = size();
            return shapes::floor({-size(), 0}, {right, 0});
        }
        case 9:
            return shapes::box({.size = vector(), .mass = number()});
        default:
            return shapes::ground({.points = {{0, 0}, {size(), 0}, {0, size()}}, .closed = true});
    }
}

/// Any number at all where one is asked for, but no more particles than a small world bears.
Blueprint Caller::rarePlan(Real s) {
    const auto few = [&] { return static_cast<int>(numbers_->below(8)) - 1; };
    const auto thick = [&] { return either() ? Real(0.03) : number() / 20; };
    const Real k = either() ? infinite : 1000 * number();
    switch (numbers_->below(8)) {
        case 0:
            return shapes::blob(
                {.radius = number(), .segments = few(), .skinRadius = thick(), .stiffness = k});
        case 1:
            return shapes::cloth({.size = vector(),
                                  .columns = few(),
                                  .rows = few(),
                                  .radius = thick(),
                                  .diagonals = either(),
                                  .stiffness = k,
                                  .strength = s});
        case 2:
            return shapes::wall({.size = vector(),
                                 .columns = few(),
                                 .rows = few(),
                                 .radius = thick(),
                                 .stiffness = k,
                                 .strength = s,
                                 .pinBottom = either()});
        case 3:
            return shapes::wheel({.radius = number(),
                                  .segments = 3 * few(),
                                  .mass = number(),
                                  .rimRadius = thick(),
                                  .spokeStiffness = k,
                                  .strength = s});
        case 4:
            return shapes::rope({.from = vector(),
                                 .to = vector(),
                                 .links = 8 * few() + 1,
                                 .radius = either() ? 0 : thick(),
                                 .stiffness = k,
                                 .damping = number(),
                                 .strength = s,
                                 .pinFirst = either(),
                                 .pinLast = either()});
        case 5:
            return shapes::polygon({.points = vectors(8), .radius = thick(), .stiffness = k});
        case 6:
            return shapes::ground({.points = vectors(6),
                                   .closed = either(),
                                   .radius = thick(),
                                   .material = material()});
        default:
            return shapes::jelly({.size = vector(),
                                  .columns = few(),
                                  .rows = few(),
                                  .mass = positive(),
                                  .radius = thick(),
                                  .stiffness = k,
                                  .damping = number(),
                                  .strength = s});
    }
}

/// What no shape would make.
Blueprint Caller::rawPlan() {
    Blueprint plan;
    const bool sane = !oneIn(4);
    for (std::size_t count = numbers_->below(7); count > 0; --count) {
        ParticleSpec particle{.position = vector()};
        if (oneIn(3)) particle.mass = sane ? positive() : number();
        if (oneIn(3)) particle.radius = sane ? positive() / 10 : number();
        particle.pinned = oneIn(8);
        plan.particles.push_back(particle);
    }
    const std::size_t ends = plan.particles.size() + (sane ? 0 : 1);
    for (std::size_t count = numbers_->below(10); count > 0 && ends > 0; --count) {
        JointSpec joint;
        joint.a = static_cast<std::uint32_t>(numbers_->below(ends));
        joint.b = static_cast<std::uint32_t>(numbers_->below(ends));
        if (sane && joint.a == joint.b) continue;
        if (either()) joint.stiffness = sane ? 1000 * positive() : number();
        if (oneIn(3)) joint.damping = sane ? positive() : number();
        if (oneIn(4)) joint.restLength = sane ? positive() : number();
        if (either()) joint.radius = sane ? Real(0.02) : number();
        joint.strength = strength();
        const bool mayBend = joint.stiffness == infinite && joint.radius > 0;
        if (oneIn(3))
            joint.bend = !sane ? number() : mayBend ? static_cast<Real>(4 * unit() - 2) : 0;
        plan.joints.push_back(joint);
    }
    for (std::size_t count = oneIn(3) ? numbers_->below(4) : 0; count > 0 && ends > 0; --count) {
        AngularJointSpec angle;
        for (auto* end : {&angle.a, &angle.b, &angle.c})
            *end = static_cast<std::uint32_t>(numbers_->below(ends));
        if (sane && (angle.a == angle.b || angle.b == angle.c || angle.a == angle.c)) continue;
        angle.stiffness = sane ? 100 * positive() : number();
        if (oneIn(3)) angle.damping = sane ? positive() : number();
        if (oneIn(4)) angle.restAngle = sane ? positive() : number();
        if (oneIn(4)) angle.upper = sane ? 4 * positive() : number();
        if (oneIn(4)) angle.lower = sane ? -positive() : number();
        if (oneIn(4)) angle.motorMax = sane ? 10 * positive() : number();
        if (oneIn(4)) angle.motorSpeed = number();
        angle.strength = strength();
        plan.angles.push_back(angle);
    }
    if (oneIn(8)) {
        Skin& skin = plan.skin.emplace();
        skin.uv.resize(sane ? plan.particles.size() : numbers_->below(8));
        for (Vec2& place : skin.uv) place = {fraction(), fraction()};
        for (std::size_t count = numbers_->below(3); count > 0 && ends > 0; --count) {
            auto& triangle = skin.triangles.emplace_back();
            for (auto& corner : triangle)
                corner = static_cast<std::uint32_t>(numbers_->below(ends));
        }
    }
    return plan;
}

void Caller::disturb(Blueprint& plan) {
    if (oneIn(6)) plan.kind = static_cast<BodyKind>(numbers_->below(3));
    plan.sensor = oneIn(10);
    plan.selfCollision = oneIn(4);
    if (oneIn(4)) plan.material = material();
    if (oneIn(6)) plan.filter = filter();
    if (oneIn(6) && !plan.joints.empty())
        plan.joints[numbers_->below(plan.joints.size())].material = material();
}

}  // namespace sulfur::test
