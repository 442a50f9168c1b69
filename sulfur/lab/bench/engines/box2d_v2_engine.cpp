// Box2D 2.4.
#include <box2d/box2d.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "bench/engine.hpp"

namespace sulfur::lab::bench {

namespace {

#include "bench/engines/box2d_v2_world.ipp"

class Box2dV2World final : public ClassicWorld {
public:
    using ClassicWorld::ClassicWorld;

    void addBlob(const Point& centre) override {
        const std::vector<Point> places = BlobPlan::places();
        const int group = -2 - static_cast<int>(blobs_.size());
        std::vector<b2Body*> bodies;
        for (const Point& place : places)
            bodies.push_back(addDisc(centre + place, BlobPlan::radius,
                                     BlobPlan::mass / static_cast<double>(places.size()), group));
        for (const auto& [a, b] : BlobPlan::springs())
            addSpring(bodies[a], bodies[b], (places[b] - places[a]).norm(), BlobPlan::stiffness,
                      BlobPlan::damping);
        blobs_.push_back(std::move(bodies));
    }
    std::vector<Point> blob(std::size_t i) const override { return places(blobs_[i]); }

    /// 8 iterations for velocities ask for 3 for positions, as its manual does; 1 for 1.
    void step() override {
        const int positions = setting_.iterations > 1 ? 3 * setting_.iterations / 8 : 1;
        world_.Step(1 / static_cast<float>(setting_.rate), setting_.iterations, positions);
    }

    void addNet(const NetPlan& plan) override {
        constexpr double radius = 0.01;
        std::vector<b2Body*> bodies;
        for (std::size_t i = 0; i < plan.points.size(); ++i)
            bodies.push_back(addDisc(plan.points[i], radius, plan.masses[i], -1));
        for (std::size_t i = 0; i < bodies.size(); ++i)
            bodies[i]->SetLinearVelocity(vec(plan.velocities[i]));
        for (const NetPlan::Spring& spring : plan.springs) {
            if (spring.isRigid())
                addLink(bodies[spring.a], bodies[spring.b], spring.length);
            else
                addSpring(bodies[spring.a], bodies[spring.b], spring.length, spring.stiffness,
                          spring.damping);
        }
        keepRope(std::move(bodies));
    }

private:
    void addLink(b2Body* a, b2Body* b, double length) {
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition());
        def.length = def.minLength = def.maxLength = static_cast<float>(length);
        world_.CreateJoint(&def);
    }

    void addSpring(b2Body* a, b2Body* b, double length, double stiffness, double damping) {
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition());
        def.length = static_cast<float>(length);
        def.minLength = 0;
        def.maxLength = b2_maxFloat;
        def.stiffness = static_cast<float>(stiffness);
        def.damping = static_cast<float>(damping);
        world_.CreateJoint(&def);
    }

    std::vector<std::vector<b2Body*>> blobs_;
};

}  // namespace

std::unique_ptr<EngineWorld> makeBox2dV2(const Setting& setting) {
    return std::make_unique<Box2dV2World>(setting);
}

std::string box2dV2Version() {
    return std::to_string(b2_version.major) + '.' + std::to_string(b2_version.minor) + '.' +
           std::to_string(b2_version.revision);
}

}  // namespace sulfur::lab::bench
