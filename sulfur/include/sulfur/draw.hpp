/// \file
/// Shows a world to whatever draws, writes or counts: a visitor that knows no graphics.
#pragma once

#include <cstdint>
#include <span>
#include <sulfur/fields.hpp>
#include <sulfur/grab.hpp>
#include <sulfur/world.hpp>

namespace sulfur {

/// What World::draw shows.
struct DrawOptions {
    bool bodies = true;       ///< DebugDraw::body
    bool particles = true;    ///< DebugDraw::particle
    bool discs = true;        ///< DebugDraw::disc
    bool joints = true;       ///< DebugDraw::joint: structural ones, and those that are capsules
    bool capsules = true;     ///< DebugDraw::capsule
    bool contacts = true;     ///< DebugDraw::contact
    bool attachments = true;  ///< DebugDraw::attachment
    bool fields = true;       ///< DebugDraw::field
    bool grabs = true;        ///< DebugDraw::grab
    bool mechanisms = true;   ///< DebugDraw::mechanism
    bool angles = true;       ///< DebugDraw::angle
    /// How much of the next tick has passed on the clock, 0 to 1: places are between those of the
    /// last two ticks, as World::interpolated gives them. Contacts are where the tick left them.
    double alpha = 1;
    /// Bodies with none of their particles in here are left out with all that is theirs, joints
    /// between bodies, attachments and mechanisms with none of their ends; fields and grabs are
    /// always shown.
    Zone view = Everywhere{};
};

/// Receives what World::draw shows, in this order: fields, then body by body (oldest first) the
/// body itself, its capsules, joints, discs, particles and angular joints, then joints between
/// bodies, attachments, mechanisms, grabs and contacts. Override what is of interest; everything
/// else does nothing. Places are in the world, metres. The world must not be changed meanwhile.
class DebugDraw {
public:
    /// A particle.
    struct Particle {
        ParticleId id = {};   ///< its handle
        BodyId body = {};     ///< its body
        Point place{0, 0};    ///< metres
        Vec2 velocity{0, 0};  ///< m/s
        bool pinned = false;  ///< whether it is held where it is
        bool asleep = false;  ///< whether its body sleeps
    };
    /// A particle with a radius.
    struct Disc {
        ParticleId id = {};   ///< the particle
        BodyId body = {};     ///< its body
        Point centre{0, 0};   ///< metres
        Real radius = 0;      ///< metres, > 0
        bool asleep = false;  ///< whether its body sleeps
    };
    /// A joint, drawn as a line.
    struct Joint {
        JointId id = {};            ///< its handle
        BodyId body = {};           ///< null for a joint between bodies
        Point a{0, 0};              ///< metres: one end
        Point b{0, 0};              ///< metres: the other end
        Real force = 0;             ///< newtons in the last tick, positive when it pulls
        Real strength = infinite;   ///< newtons
        Real stiffness = infinite;  ///< N/m
        bool asleep = false;        ///< whether the body of its end a sleeps
    };
    /// The surface of a joint with a radius; of a bent one, a part of it.
    struct Capsule {
        JointId id = {};      ///< the joint
        BodyId body = {};     ///< null for a joint between bodies
        Point a{0, 0};        ///< metres: one end of the axis
        Point b{0, 0};        ///< metres: the other end
        Real radius = 0;      ///< metres, > 0
        bool asleep = false;  ///< whether the body of its end a sleeps
    };
    /// A body.
    struct Body {
        BodyId id = {};                     ///< its handle
        BodyKind kind = BodyKind::dynamic;  ///< who moves it
        Point centreOfMass{0, 0};           ///< metres
        Point low{0, 0};                    ///< metres: lower left corner around its particles
        Point high{0, 0};                   ///< metres: upper right corner around its particles
        bool asleep = false;                ///< whether it sleeps
    };
    /// A particle held at a point of a body.
    struct Attachment {
        AttachmentId id = {};             ///< its handle
        Point particle{0, 0};             ///< metres: the particle
        Point point{0, 0};                ///< metres: where it should be
        std::span<const Point> supports;  ///< metres: what carries that point; only during the call
    };
    /// A force field.
    struct FieldShape {
        FieldId id = {};               ///< its handle
        const Field* field = nullptr;  ///< what it is; only during the call
    };
    /// A grab.
    struct Grab {
        GrabId id = {};      ///< its handle
        GrabInfo info = {};  ///< where it holds and pulls
    };
    /// A mechanism. Bodies of one particle that are its pins are shown as bodies too.
    struct Mechanism {
        MechanismId id = {};      ///< its handle
        MechanismInfo info = {};  ///< what it is and does
        /// Metres, only during the call. Hinge and weld: the pin, or without one a place of each
        /// body. Slider: where its value is 0, then where it is; on a rail its line, with chords of
        /// arcs, then where it is. Distance: both points. Pulley: the rope from a over the frame to
        /// b. Gear: the first place of each of its two mechanisms.
        std::span<const Point> places;
    };
    /// An angular joint.
    struct Angle {
        AngleInfo info = {};  ///< what it is and does, with its handle
        Point a{0, 0};        ///< metres: one neighbour
        Point b{0, 0};        ///< metres: the corner
        Point c{0, 0};        ///< metres: the other neighbour
        bool asleep = false;  ///< whether its body sleeps
    };

    virtual ~DebugDraw() = default;
    /// Called for each body.
    virtual void body(const Body&) {}
    /// Called for each particle.
    virtual void particle(const Particle&) {}
    /// Called for each particle with a radius.
    virtual void disc(const Disc&) {}
    /// Called for each joint.
    virtual void joint(const Joint&) {}
    /// Called for each joint with a radius; of a bent one, for each of its parts, from a to b.
    virtual void capsule(const Capsule&) {}
    /// Called for each contact of the last tick.
    virtual void contact(const ContactInfo&) {}
    /// Called for each attachment.
    virtual void attachment(const Attachment&) {}
    /// Called for each force field.
    virtual void field(const FieldShape&) {}
    /// Called for each grab.
    virtual void grab(const Grab&) {}
    /// Called for each mechanism.
    virtual void mechanism(const Mechanism&) {}
    /// Called for each angular joint.
    virtual void angle(const Angle&) {}
};

}  // namespace sulfur
