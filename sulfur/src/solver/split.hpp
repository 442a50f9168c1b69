// Bodies that fall apart.
#pragma once

#include "model/state.hpp"

namespace sulfur::detail {

/// Whether an attachment holds the particle, or is held by it. Linear in the attachments.
bool isAttached(const State& state, std::uint32_t particle);

/// After joints between the given particles broke: what their bodies' joints no longer connect
/// becomes bodies of its own, and a particle without joints and radius goes. Tells so in
/// State::events.
void splitBodies(State& state, const std::vector<ParticleId>& ends);

}  // namespace sulfur::detail
