// Shows a world to functions of the caller.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

namespace {

/// Calls those functions that there are.
class Visitor final : public DebugDraw {
public:
    explicit Visitor(const SulfurDebugDraw& to) : to_(to) {}

    void body(const Body& b) override {
        tell(to_.body, SulfurDrawnBody{toC(b.id), toC(b.kind), toC(b.centreOfMass), toC(b.low),
                                       toC(b.high), b.asleep});
    }
    void particle(const Particle& p) override {
        tell(to_.particle, SulfurDrawnParticle{toC(p.id), toC(p.body), toC(p.place),
                                               toC(p.velocity), p.pinned, p.asleep});
    }
    void disc(const Disc& d) override {
        tell(to_.disc,
             SulfurDrawnDisc{toC(d.id), toC(d.body), toC(d.centre), toC(d.radius), d.asleep});
    }
    void joint(const Joint& j) override {
        tell(to_.joint, SulfurDrawnJoint{toC(j.id), toC(j.body), toC(j.a), toC(j.b), toC(j.force),
                                         toC(j.strength), toC(j.stiffness), j.asleep});
    }
    void capsule(const Capsule& c) override {
        tell(to_.capsule, SulfurDrawnCapsule{toC(c.id), toC(c.body), toC(c.a), toC(c.b),
                                             toC(c.radius), c.asleep});
    }
    void contact(const ContactInfo& c) override { tell(to_.contact, toC(c)); }
    void attachment(const Attachment& a) override {
        SulfurDrawnAttachment drawn{toC(a.id), toC(a.particle), toC(a.point), {}, 0};
        for (const Point& support : a.supports) drawn.supports[drawn.count++] = toC(support);
        tell(to_.attachment, drawn);
    }
    void field(const FieldShape& f) override {
        tell(to_.field, SulfurDrawnField{toC(f.id), toC(*f.field)});
    }
    void grab(const Grab& g) override { tell(to_.grab, SulfurDrawnGrab{toC(g.id), toC(g.info)}); }
    void mechanism(const Mechanism& m) override {
        SulfurDrawnMechanism drawn{toC(m.id), toC(m.info), {}, 0};
        for (const Point& place : m.places) drawn.places[drawn.count++] = toC(place);
        tell(to_.mechanism, drawn);
    }
    void angle(const Angle& a) override {
        tell(to_.angle, SulfurDrawnAngle{toC(a.info), toC(a.a), toC(a.b), toC(a.c), a.asleep});
    }

private:
    template <class Shown>
    void tell(void (*function)(void*, const Shown*), const Shown& shown) {
        if (function) function(to_.user, &shown);
    }

    const SulfurDebugDraw& to_;
};

}  // namespace

extern "C" {

SulfurDrawOptions sulfur_draw_options_default(void) {
    return toC(DrawOptions{});
}

SulfurDebugDraw sulfur_debug_draw_default(void) {
    return {};
}

SulfurResult sulfur_world_draw(const SulfurWorld* world, const SulfurDebugDraw* to,
                               const SulfurDrawOptions* options) {
    return call([&] {
        Visitor visitor(required(to, "what it is shown to"));
        of(world).draw(visitor, orDefault<DrawOptions>(options));
    });
}

}  // extern "C"

}  // namespace sulfur::c
