#include "debug_painter.hpp"

#include <atlax/debug_draw.hpp>
#include <cmath>
#include <sulfur/draw.hpp>

namespace sulfurchamber {
namespace {

using atlax::DebugState;
using atlax::Vec2;

/// Newtons that count as a full load for a joint that never breaks.
constexpr float fullLoad = 500;

class Adaptor final : public sulfur::DebugDraw {
public:
    Adaptor(atlax::DebugPen& pen, const sulfur::World& world) : pen_(pen), world_(world) {}

    void body(const Body& body) override {
        const Vec2 low(body.low), high(body.high);
        const DebugState state = stateOf(body.kind, body.asleep);
        pen_.bounds({low, high - low}, state);
        if (body.kind == sulfur::BodyKind::dynamic)
            pen_.centreOfMass(Vec2(body.centreOfMass), state);
    }
    void particle(const Particle& particle) override {
        pen_.particle(Vec2(particle.place), particle.pinned
                                                ? DebugState::Fixed
                                                : stateOf(particle.body, particle.asleep));
    }
    void disc(const Disc& disc) override {
        pen_.disc(Vec2(disc.centre), static_cast<float>(disc.radius),
                  stateOf(disc.body, disc.asleep));
    }
    void joint(const Joint& joint) override {
        const auto strength = static_cast<float>(joint.strength);
        const float full = std::isfinite(strength) && strength > 0 ? strength : fullLoad;
        pen_.joint(Vec2(joint.a), Vec2(joint.b), static_cast<float>(joint.force) / full,
                   stateOf(joint.body, joint.asleep));
    }
    void capsule(const Capsule& capsule) override {
        pen_.capsule(Vec2(capsule.a), Vec2(capsule.b), static_cast<float>(capsule.radius),
                     stateOf(capsule.body, capsule.asleep));
    }
    void contact(const sulfur::ContactInfo& contact) override {
        pen_.contact(Vec2(contact.point), Vec2(contact.normal),
                     static_cast<float>(contact.impulse));
    }
    void attachment(const Attachment& attachment) override {
        pen_.spring(Vec2(attachment.particle), Vec2(attachment.point));
    }
    void grab(const Grab& grab) override {
        pen_.spring(Vec2(grab.info.point), Vec2(grab.info.target));
    }
    void mechanism(const Mechanism& mechanism) override {
        // A pin alone is shown as what holds it: an attachment.
        for (std::size_t i = 1; i < mechanism.places.size(); ++i)
            pen_.spring(Vec2(mechanism.places[i - 1]), Vec2(mechanism.places[i]));
    }
    void field(const FieldShape& shape) override {
        std::visit([this](const auto& field) { drawField(field); }, *shape.field);
    }

private:
    static DebugState stateOf(sulfur::BodyKind kind, bool asleep) {
        if (kind == sulfur::BodyKind::fixed) return DebugState::Fixed;
        if (kind == sulfur::BodyKind::kinematic) return DebugState::Driven;
        return asleep ? DebugState::Asleep : DebugState::Moving;
    }
    /// A joint between bodies has none.
    DebugState stateOf(sulfur::BodyId body, bool asleep) const {
        return stateOf(world_.contains(body) ? world_.kind(body) : sulfur::BodyKind::dynamic,
                       asleep);
    }

    void drawZone(const sulfur::Zone& zone, Vec2 direction) {
        if (const auto* box = std::get_if<sulfur::BoxZone>(&zone)) {
            const Vec2 low(box->low), high(box->high);
            pen_.field(atlax::Rect{low, high - low}, direction);
        } else if (const auto* circle = std::get_if<sulfur::CircleZone>(&zone)) {
            pen_.field(Vec2(circle->centre), static_cast<float>(circle->radius), direction);
        }
    }
    void drawField(const sulfur::UniformField& field) {
        drawZone(field.zone, atlax::normalized(Vec2(field.acceleration)));
    }
    void drawField(const sulfur::WindField& field) {
        drawZone(field.zone, atlax::normalized(Vec2(field.velocity)));
    }
    void drawField(const sulfur::RadialField& field) {
        pen_.field(Vec2(field.centre), static_cast<float>(field.core), {});
        if (std::isfinite(field.reach))
            pen_.field(Vec2(field.centre), static_cast<float>(field.reach), {});
    }

    atlax::DebugPen& pen_;
    const sulfur::World& world_;
};

}  // namespace

void paintDebug(atlax::Canvas& canvas, const sulfur::World& world, double alpha) {
    atlax::DebugStyle style;
    // Impulses are those of one tick: a force of a newton is a centimetre long at any rate.
    style.metresPerNewtonSecond = 0.01f * static_cast<float>(world.settings().tickRate);
    const auto tell = [&](atlax::DebugPen& pen) {
        Adaptor adaptor(pen, world);
        world.draw(adaptor, {.alpha = alpha});
    };
    atlax::drawDebug(canvas, tell, style);
}

}  // namespace sulfurchamber
