/// \file
/// Handles to what lives in a World.
#pragma once

#include <compare>
#include <cstdint>
#include <sulfur/version.hpp>

namespace sulfur {

/// A generational handle. It stays valid until the thing is removed and is never reused for another
/// one: a stale handle is recognised and refused. The default-constructed handle is null.
template <class Tag>
struct Handle {
    std::uint32_t index = 0;       ///< slot, counted from 1; 0 is null
    std::uint32_t generation = 0;  ///< of the slot

    /// Whether it is not null; what it refers to may be gone all the same.
    explicit operator bool() const { return index != 0; }
    /// An order without meaning, for maps.
    friend auto operator<=>(const Handle&, const Handle&) = default;
};

using ParticleId = Handle<struct ParticleTag>;      ///< a particle
using JointId = Handle<struct JointTag>;            ///< a joint
using AngleId = Handle<struct AngleTag>;            ///< an angular joint
using BodyId = Handle<struct BodyTag>;              ///< a body
using AttachmentId = Handle<struct AttachmentTag>;  ///< an attachment; see World::attach
using FieldId = Handle<struct FieldTag>;            ///< a force field
using GrabId = Handle<struct GrabTag>;              ///< a grab; see World::grab
using MechanismId = Handle<struct MechanismTag>;    ///< a hinge, slider, ...; see World::hinge

}  // namespace sulfur
