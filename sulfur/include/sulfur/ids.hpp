// Handles to what lives in a World.
#pragma once

#include <compare>
#include <cstdint>

namespace sulfur {

/// A generational handle. It stays valid until the thing is removed and is never reused for another
/// one: a stale handle is recognised and refused. The default-constructed handle is null.
template <class Tag>
struct Handle {
    std::uint32_t index = 0;  ///< slot, counted from 1; 0 is null
    std::uint32_t generation = 0;

    explicit operator bool() const { return index != 0; }
    friend auto operator<=>(const Handle&, const Handle&) = default;
};

using ParticleId = Handle<struct ParticleTag>;
using JointId = Handle<struct JointTag>;
using BodyId = Handle<struct BodyTag>;
using AttachmentId = Handle<struct AttachmentTag>;
using FieldId = Handle<struct FieldTag>;
using GrabId = Handle<struct GrabTag>;

}  // namespace sulfur
