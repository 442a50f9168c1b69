// The joints of a world as a structure of arrays, and attachments.
#pragma once

#include <array>
#include <cstdint>
#include <sulfur/ids.hpp>
#include <sulfur/material.hpp>
#include <sulfur/math.hpp>
#include <vector>

#include "core/bend.hpp"
#include "core/slots.hpp"

namespace sulfur::detail {

/// How a joint is solved. Derived by classifyJoints(), never chosen.
enum class JointKind : std::uint8_t {
    explicitElastic,  // as a force
    implicitElastic,  // partly as a force, the rest as a compliant constraint
    rigid,            // as a constraint
};

/// Beyond, rounding is larger than the stretch under any force: as good as rigid.
inline constexpr Real maxStiffness = Real(1e15);

struct Joints {
    std::vector<std::uint32_t> a, b;      // particles, dense indices
    std::vector<Real> restLength;         // m
    std::vector<Real> stiffness;          // N/m
    std::vector<Real> damping;            // N s/m
    std::vector<Real> explicitStiffness;  // N/m, the part of the stiffness that is a force
    std::vector<Real> explicitDamping;    // N s/m, the same of the damping
    std::vector<Real> lambda;             // this tick's multiplier
    std::vector<Real> force;              // N in the last tick, positive pulls
    std::vector<JointKind> kind;
    std::vector<std::uint8_t> inCluster;  // held by a rigid component, so never solved
    std::vector<std::uint8_t> braced;     // a side of a triangle of springs, so no link of a tree
    std::vector<Real> radius;             // m, > 0: a capsule
    std::vector<Bend> bend;               // of capsules that are arcs
    std::vector<Real> strength;           // N
    std::vector<Material> material;       // of the surface, if the joint has its own
    std::vector<std::uint8_t> ownMaterial;
    std::vector<std::uint32_t> body;  // dense index, or none between bodies
    std::vector<JointId> id;

    std::size_t size() const { return a.size(); }

    template <class Function>
    void forEachArray(Function&& f) {
        f(a);
        f(b);
        f(restLength);
        f(stiffness);
        f(damping);
        f(explicitStiffness);
        f(explicitDamping);
        f(lambda);
        f(force);
        f(kind);
        f(inCluster);
        f(braced);
        f(radius);
        f(bend);
        f(strength);
        f(material);
        f(ownMaterial);
        f(body);
        f(id);
    }

    template <class Archive>
    void archive(Archive& archive) {
        forEachArray(archive);
    }
};

inline bool isRigid(const Joints& joints, std::uint32_t j) {
    return joints.stiffness[j] > maxStiffness;
}

/// Holds a particle at a point that moves with up to three others: the point is the sum of
/// weight_i x_i with weights that add up to 1, so it turns with a rigid body and stretches with
/// a soft one.
struct Attachment {
    std::uint32_t particle = none;
    std::uint32_t count = 0;  // of supports
    std::array<std::uint32_t, 3> support{none, none, none};
    std::array<Real, 3> weight{0, 0, 0};
    Vec2 force{0, 0};  // N on the particle in the last tick
    AttachmentId id;

    template <class Archive>
    void archive(Archive& a) {
        a(particle);
        a(count);
        a(support);
        a(weight);
        a(force);
        a(id);
    }
};

}  // namespace sulfur::detail
