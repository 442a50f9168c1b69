// Tools that work particle by particle and joint by joint.
#include <algorithm>
#include <utility>

#include "geometry.hpp"
#include "tool.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using sulfur::Real;

constexpr double particleMass = 0.2;     // kg
constexpr double particleRadius = 0.05;  // metres
constexpr double jointRadius = 0.02;     // metres
constexpr double elastic = 600;          // N/m
constexpr double elasticDamping = 2;     // N s/m

class ParticleTool final : public Tool {
public:
    using Tool::Tool;
    void press(const Pointer& pointer) override {
        pressed_ = true;
        move(pointer);
    }
    void move(const Pointer& pointer) override { bench().snapped(pointer); }
    void cancel() override { pressed_ = false; }
    void release(const Pointer& pointer) override {
        if (!std::exchange(pressed_, false)) return;
        sulfur::scene::Prefab prefab;
        prefab.blueprint.name = "particle";
        prefab.blueprint.particles.push_back(
            {.mass = Real(particleMass), .radius = Real(particleRadius), .pinned = pointer.shift});
        sulfur::scene::Placement placement;
        placement.pose.position = bench().snapped(pointer);
        document().edit("Add particle", [&] { document().add(prefab, placement); });
    }
    std::string hint() const override {
        return "Click to put a particle, with Shift a pinned one, for the joint tool";
    }

private:
    bool pressed_ = false;
};

class JointTool final : public Tool {
public:
    using Tool::Tool;

    void press(const Pointer& pointer) override {
        const auto pick = particleAt(world(), pointer.position, reachOf(pointer));
        if (!pick) return;
        from_ = pick->particle;
        to_ = pointer.position;
    }
    void move(const Pointer& pointer) override {
        to_ = pointer.position;
        if (const auto pick = particleAt(world(), to_, reachOf(pointer)))
            to_ = world().position(pick->particle);
    }
    void release(const Pointer& pointer) override {
        if (!from_) return;
        const auto from = std::exchange(from_, {});
        const auto pick = particleAt(world(), pointer.position, reachOf(pointer));
        if (!pick || pick->particle == from || !world().contains(from)) return;
        sulfur::JointSpec joint;
        joint.radius = Real(jointRadius);
        if (pointer.shift) {
            joint.stiffness = Real(elastic);
            joint.damping = Real(elasticDamping);
        }
        document().edit(pointer.shift ? "Add elastic joint" : "Add rigid joint",
                        [&] { document().join(from, pick->particle, joint); });
    }
    void cancel() override { from_ = {}; }

    Preview preview() const override {
        if (!from_ || !world().contains(from_)) return {};
        const Point at = world().position(from_);
        return {Preview::Kind::line, at, to_, (to_ - at).norm()};
    }
    std::string hint() const override {
        return from_ ? "Let go on another particle; with Shift the joint is elastic"
                     : "Drag from one particle to another to join them; with Shift elastically";
    }

private:
    static double reachOf(const Pointer& pointer) { return std::max(pointer.reach, 0.05); }

    sulfur::ParticleId from_;
    Point to_{0, 0};
};

}  // namespace

std::unique_ptr<Tool> makeParticleTool(Workbench& bench, ToolKind kind) {
    if (kind == ToolKind::joint) return std::make_unique<JointTool>(bench);
    return std::make_unique<ParticleTool>(bench);
}

}  // namespace sulfurchamber
