#include "grip.hpp"

#include <algorithm>
#include <cmath>

#include "geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::World;

constexpr double gripFrequency = 15;  // rad/s of the body on the spring, undamped
constexpr double dampingRatio = 0.9;  // of critical: follows quickly, overshoots hardly
constexpr double strongest = 300;     // m/s^2 that the spring gives at most

bool movable(const World& world, sulfur::BodyId body) {
    return body && world.kind(body) == sulfur::BodyKind::dynamic;
}

}  // namespace

std::optional<Grip> Grip::take(const World& world, const Point& point, double reach,
                               const std::function<bool(sulfur::BodyId)>& counts) {
    Grip grip;
    grip.target_ = point;
    const auto particle = particleAt(world, point, reach);
    const auto may = [&](sulfur::BodyId body) {
        return movable(world, body) && (!counts || counts(body));
    };
    if (particle && may(particle->body)) {
        grip.ends_[0] = {particle->particle, 1};
        grip.count_ = 1;
    } else {
        // The inside of a body counts as its nearest joint.
        const sulfur::BodyId body = bodyAt(world, point, reach, {.counts = counts});
        if (!may(body)) return std::nullopt;
        double nearest = 0;
        for (const sulfur::JointId joint : world.joints(body)) {
            const auto info = world.info(joint);
            const Point a = world.position(info.a);
            const Point edge = world.position(info.b) - a;
            const double along =
                std::clamp((point - a).dot(edge) / std::max(1e-12, edge.squaredNorm()), 0.0, 1.0);
            const double distance = (a + along * edge - point).norm();
            if (grip.count_ != 0 && distance >= nearest) continue;
            nearest = distance;
            grip.ends_ = {End{info.a, 1 - along}, End{info.b, along}};
            grip.count_ = 2;
        }
        if (grip.count_ == 0) return std::nullopt;
    }
    grip.offset_ = point - grip.anchor(world);
    return grip;
}

bool Grip::holds(const World& world) const {
    return std::all_of(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(count_),
                       [&](const End& end) { return world.contains(end.particle); });
}

Point Grip::anchor(const World& world) const {
    Point place{0, 0};
    for (std::size_t i = 0; i < count_; ++i)
        place += ends_[i].weight * world.position(ends_[i].particle);
    return place + offset_;
}

std::vector<Push> Grip::pushes(const World& world) const {
    std::vector<Push> pushes;
    if (!holds(world)) return pushes;
    const Point stretch = target_ - anchor(world);
    const double h = static_cast<double>(world.tickDuration());
    const auto first = world.info(ends_[0].particle);
    const double mass = static_cast<double>(world.mass(first.body));
    for (std::size_t i = 0; i < count_; ++i) {
        const auto info = world.info(ends_[i].particle);
        const double share = mass * ends_[i].weight;
        if (info.pinned || !(share > 0)) continue;
        const double own = static_cast<double>(info.mass);
        // Explicit forces on this particle alone stay stable below 4 m/h^2 and 2 m/h.
        const double stiffness =
            std::min(share * gripFrequency * gripFrequency, 0.8 * own / (h * h));
        const double damping = std::min(2 * dampingRatio * share * gripFrequency, 0.5 * own / h);
        Point force = stiffness * stretch - damping * info.velocity.cast<double>();
        const double limit = strongest * share;
        if (const double size = force.norm(); size > limit) force *= limit / size;
        pushes.push_back({ends_[i].particle, force.cast<Real>()});
    }
    return pushes;
}

}  // namespace sulfurchamber
