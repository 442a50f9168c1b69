// The bodies of a world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <sulfur/blueprint.hpp>
#include <sulfur/ids.hpp>
#include <vector>

#include "core/slots.hpp"

namespace sulfur::detail {

/// How many there were when something was derived from them.
struct Counts {
    std::uint32_t particles = 0, joints = 0, bodies = 0;
};

struct BodyRecord {
    BodyId id;
    BodyKind kind = BodyKind::dynamic;
    bool asleep = false;
    bool disabled = false;            // takes no part, and is not asleep
    bool sleepless = false;           // never falls asleep, nor whoever is in its island
    bool moving = false;              // kinematic: has a target for the next tick
    bool stopping = false;            // kinematic: had a target for the last tick
    bool clustersStale = true;        // its rigid components must be found again
    bool selfCollision = false;       // its own parts touch each other
    bool strained = false;            // they were not, because it was bent out of shape
    std::uint32_t gone = 0;           // removed: so many of its particles still take place
    std::uint32_t ties = 0;           // joints to other bodies and ends of attachments; derived
    Real restingTime = 0;             // s for which its island has been at rest
    BodyId nextAsleep;                // asleep: the next of a ring of all that must wake with it
    std::uint32_t firstParticle = 0;  // dense index
    std::uint32_t frame = none;       // fixed: the mover on which all of it stands, or none
    Material material;
    Filter filter;
    bool sensor = false;
    std::uint64_t userData = 0;
    Real gravityScale = 1;
    bool fixedRotation = false;                  // its rigid components do not turn
    Real linearDamping = 0, angularDamping = 0;  // 1/s
    Pose target;
    // Kinematic, where spin is not 0: it turns about its centre of mass, which goes with `drift`;
    // the target is then where it is.
    double spin = 0;    // rad/s
    Point drift{0, 0};  // m/s
    // Of its own frame where particles do not show it, which is that of a disc before it has
    // rolled; now, and when the last tick began. No step asks for them.
    Point turn{1, 0}, turnBefore{1, 0};  // (cos, sin)
    std::string name;
    std::optional<Skin> skin;
    std::vector<ParticleId> particles;
    std::vector<JointId> joints;

    template <class Archive>
    void archive(Archive& a) {
        a(id);
        a(kind);
        a(asleep);
        a(disabled);
        a(sleepless);
        a(moving);
        a(stopping);
        a(clustersStale);
        a(strained);
        a(gone);
        a(selfCollision);
        a(restingTime);
        a(nextAsleep);
        a(firstParticle);
        a(frame);
        a(material);
        a(filter);
        a(sensor);
        a(userData);
        a(gravityScale);
        a(fixedRotation);
        a(linearDamping);
        a(angularDamping);
        a(target.position);
        a(target.angle);
        a(spin);
        a(drift);
        a(turn);
        a(turnBefore);
        a(name);
        bool skinned = skin.has_value();
        a(skinned);
        if (skinned) {
            if (!skin) skin.emplace();
            a(skin->texture);
            a(skin->uv);
            a(skin->triangles);
        } else {
            skin.reset();
        }
        a(particles);
        a(joints);
    }
};

inline bool isDamped(const BodyRecord& body) {
    return body.linearDamping != 0 || body.angularDamping != 0;
}

}  // namespace sulfur::detail
