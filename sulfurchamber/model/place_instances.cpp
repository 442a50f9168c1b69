// New instances of a template: where they come to lie, and what they are called.
#include <algorithm>
#include <map>
#include <set>

#include "fitting.hpp"
#include "instance_parts.hpp"
#include "instances.hpp"

namespace sulfurchamber {

namespace {

using sulfur::BodyId;
using sulfur::Point;
using sulfur::scene::Placement;
using sulfur::scene::Scene;

// How far a scene must go up so that what is fixed below its middle is not inside of it.
double liftOver(const sulfur::World& world, const Bounds& bounds) {
    double top = bounds.low.y();
    const double middle = bounds.centre().y();
    for (const BodyId body : world.bodies()) {
        if (world.kind(body) != sulfur::BodyKind::fixed) continue;
        for (const sulfur::JointId joint : world.joints(body)) {
            const auto info = world.info(joint);
            Point a = world.position(info.a), b = world.position(info.b);
            if (a.x() > b.x()) std::swap(a, b);
            if (b.x() < bounds.low.x() || a.x() > bounds.high.x()) continue;
            const double width = std::max(b.x() - a.x(), 1e-9);
            for (const double x : {bounds.low.x(), bounds.high.x(), a.x(), b.x()}) {
                const double share = std::clamp((x - a.x()) / width, 0.0, 1.0);
                const double y = a.y() + share * (b.y() - a.y()) + static_cast<double>(info.radius);
                const double at = a.x() + share * width;
                if (at >= bounds.low.x() && at <= bounds.high.x() && y <= middle)
                    top = std::max(top, y);
            }
        }
    }
    return top - bounds.low.y();
}

}  // namespace

std::vector<BodyId> placeTemplate(Document& document, const Template& made, const Point& at) {
    const auto own = definition(document.scene(), made.name());
    Scene scene = own ? own->scene : made.scene;
    const auto thrusters = thrustersOf(scene);
    scene.extra.clear();
    setThrusters(scene, thrusters);
    define(scene, own ? *own : made);
    for (Placement& body : scene.bodies) setMembership(body, {made.name(), made.name(), body.id});
    for (auto& mechanism : scene.mechanisms) setPart(mechanism, mechanism.id);
    Bounds bounds = boundsOf(scene);
    bounds.low += at;
    bounds.high += at;
    return document.insert(scene, at + Point(0, liftOver(document.world(), bounds)));
}

void renameInstances(Scene& scene, const std::vector<std::string>& newBodies) {
    const std::set<std::string> fresh(newBodies.begin(), newBodies.end());
    std::set<std::string> taken;
    for (const Placement& body : scene.bodies)
        if (!fresh.contains(body.id))
            if (const auto membership = membershipOf(body)) taken.insert(membership->instance);
    std::map<std::string, std::string> renamed;
    for (Placement& body : scene.bodies) {
        if (!fresh.contains(body.id)) continue;
        auto membership = membershipOf(body);
        if (!membership) continue;
        auto [found, isNew] = renamed.emplace(membership->instance, membership->instance);
        if (isNew) {
            for (int n = 2; taken.contains(found->second); ++n)
                found->second = membership->name + " " + std::to_string(n);
            taken.insert(found->second);
        }
        if (found->second == membership->instance) continue;
        membership->instance = found->second;
        setMembership(body, *membership);
    }
}

}  // namespace sulfurchamber
