#include "stretch.hpp"

#include <algorithm>
#include <cmath>

#include "plan.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;
using sulfur::Vec2;
using sulfur::scene::Prefab;

constexpr Real thickest = Real(0.2);  // of a side may be the radius of its capsules

// Every length of a recipe. Its mass goes with the area.
template <class Options>
void scaleRecipe(Options& o, Real f) {
    if constexpr (requires { o.size; }) o.size *= f;
    if constexpr (requires { o.from; }) o.from *= f;
    if constexpr (requires { o.to; }) o.to *= f;
    if constexpr (requires { o.radius; }) o.radius *= f;
    if constexpr (requires { o.rimRadius; }) o.rimRadius *= f;
    if constexpr (requires { o.skinRadius; }) o.skinRadius *= f;
    if constexpr (requires { o.sag; }) o.sag *= f;
    if constexpr (requires { o.points; })
        for (Vec2& point : o.points) point *= f;
    if constexpr (requires { o.mass; }) o.mass *= f * f;
}

template <class Options>
void stretchRecipe(Options& o, const Vec2& f) {
    Real more = f.x() * f.y();
    if constexpr (requires { o.size; }) {
        o.size = o.size.cwiseProduct(f);
        o.radius = std::min(o.radius, thickest * o.size.minCoeff());
    }
    if constexpr (requires { o.to; }) {
        const Real before = (o.to - o.from).norm();
        o.from = o.from.cwiseProduct(f);
        o.to = o.to.cwiseProduct(f);
        more = (o.to - o.from).norm() / before;
        if constexpr (requires { o.sag; }) o.sag *= more;
    }
    if constexpr (requires { o.points; }) {
        Vec2 low = o.points[0], high = low;
        for (Vec2& point : o.points) {
            point = point.cwiseProduct(f);
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        if constexpr (requires { o.mass; })
            o.radius = std::min(o.radius, Real(0.1) * Vec2(high - low).minCoeff());
    }
    if constexpr (requires { o.mass; }) o.mass *= more;
}

// An explicit one, particle by particle.
void stretchParts(sulfur::Blueprint& plan, const Vec2& f) {
    const bool uniform = f.x() == f.y();
    const auto length = [&](const sulfur::JointSpec& joint) {
        return (plan.particles[joint.a].position - plan.particles[joint.b].position).norm();
    };
    std::vector<Real> before;
    for (const auto& joint : plan.joints) before.push_back(length(joint));
    for (auto& particle : plan.particles) {
        particle.position = particle.position.cwiseProduct(f);
        particle.mass *= f.x() * f.y();
        if (uniform) particle.radius *= f.x();
    }
    for (std::size_t i = 0; i < plan.joints.size(); ++i) {
        auto& joint = plan.joints[i];
        if (uniform) joint.radius *= f.x();
        if (joint.restLength && before[i] > 0)
            *joint.restLength *= uniform ? f.x() : length(joint) / before[i];
    }
    if (uniform) return;
    for (auto& angle : plan.angles) angle.restAngle.reset();
}

}  // namespace

bool canStretch(const Prefab& prefab) {
    using namespace sulfur::shapes;
    const auto& g = prefab.generator;
    if (std::holds_alternative<WheelOptions>(g) || std::holds_alternative<BlobOptions>(g))
        return false;
    const auto& particles = prefab.blueprint.particles;
    return std::none_of(particles.begin(), particles.end(),
                        [](const auto& particle) { return particle.radius > 0; });
}

void stretchPlan(Prefab& prefab, const Point& factors) {
    const Vec2 f = factors.cast<Real>();
    if (prefab.generator.index() == 0) {
        stretchParts(prefab.blueprint, f);
        return;
    }
    std::visit(
        [&](auto& options) {
            if (f.x() == f.y())
                scaleRecipe(options, f.x());
            else
                stretchRecipe(options, f);
        },
        prefab.generator);
    rebuild(prefab);
}

}  // namespace sulfurchamber
