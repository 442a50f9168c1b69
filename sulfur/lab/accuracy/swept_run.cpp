#include "accuracy/swept_run.hpp"

#include <algorithm>
#include <cmath>

#include "battery/measure.hpp"
#include "integrators/position_sweeps.hpp"

namespace sulfur::lab {

namespace {

/// A body of a scene for the sweeps.
SweptBody sweptOf(const bench::BodyPlan& plan) {
    SweptBody body{.place = plan.place, .turn = Vec(std::cos(plan.angle), std::sin(plan.angle))};
    if (plan.mover != bench::Mover::physics) return body;
    body.inverseMass = 1 / plan.mass();
    body.inverseInertia = 1 / plan.inertia();
    return body;
}

class SweptRun final : public Run {
public:
    SweptRun(const AccuracyScene& scene, int rate, int sweeps)
        : links_(linksOf(scene)),
          method_(bodiesOf(scene), links_, scene.gravity, sweeps),
          h_(1.0 / rate) {}
    void advance(long ticks) override {
        for (long i = 0; i < ticks; ++i) method_.step(h_);
    }
    Vecs places() const override {
        Vecs all;
        for (const SweptBody& body : method_.bodies()) all.push_back(body.place);
        return all;
    }
    double strain(const AccuracyScene& scene) const override {
        if (scene.pins.empty()) return Run::strain(scene);
        double largest = 0;
        for (const SweptLink& link : links_) {
            const SweptBody &a = method_.bodies()[link.a], &b = method_.bodies()[link.b];
            largest = worst(largest, (b.at(link.onB) - a.at(link.onA)).norm());
        }
        return largest;
    }

private:
    static std::vector<SweptBody> bodiesOf(const AccuracyScene& scene) {
        std::vector<SweptBody> bodies;
        for (std::size_t i = 0; i < scene.masses.size(); ++i)
            bodies.push_back({.place = scene.start.x[i],
                              .velocity = scene.start.v[i],
                              .inverseMass = scene.masses[i] > 0 ? 1 / scene.masses[i] : 0});
        for (const bench::BodyPlan& plan : scene.bodies) bodies.push_back(sweptOf(plan));
        return bodies;
    }
    static std::vector<SweptLink> linksOf(const AccuracyScene& scene) {
        std::vector<SweptLink> links;
        for (const SceneJoint& joint : scene.joints)
            links.push_back({.a = joint.a, .b = joint.b, .length = joint.restLength});
        for (const bench::PinPlan& pin : scene.pins)
            links.push_back({.a = pin.a,
                             .b = pin.b,
                             .onA = scene.bodies[pin.a].sockets[pin.socketA],
                             .onB = scene.bodies[pin.b].sockets[pin.socketB]});
        return links;
    }

    std::vector<SweptLink> links_;
    PositionSweeps method_;
    double h_;
};

}  // namespace

bool canBeSwept(const AccuracyScene& scene) {
    return scene.isTied() &&
           std::all_of(scene.joints.begin(), scene.joints.end(),
                       [](const SceneJoint& joint) { return std::isinf(joint.stiffness); });
}

std::unique_ptr<Run> makeSweptRun(const AccuracyScene& scene, int rate, int sweeps) {
    return std::make_unique<SweptRun>(scene, rate, sweeps);
}

}  // namespace sulfur::lab
