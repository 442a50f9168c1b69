// Skins of bodies that lose particles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/slots.hpp"
#include "model/bodies.hpp"

namespace sulfur::detail {

/// Leaves of a body's skin what lies on particles for which `stays(place in the body)`. Called
/// before the particles themselves go.
template <class Predicate>
void cutSkin(BodyRecord& body, Predicate&& stays) {
    if (!body.skin) return;
    std::size_t staying = 0;
    for (std::size_t k = 0; k < body.particles.size(); ++k) staying += stays(k) ? 1 : 0;
    if (staying == body.particles.size()) return;
    Skin cut;
    cut.texture = body.skin->texture;
    std::vector<std::uint32_t> newPlace(body.particles.size(), none);
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < newPlace.size(); ++k) {
        if (!stays(k)) continue;
        newPlace[k] = next++;
        if (k < body.skin->uv.size()) cut.uv.push_back(body.skin->uv[k]);
    }
    for (auto triangle : body.skin->triangles) {
        bool whole = true;
        for (auto& corner : triangle) {
            corner = newPlace[corner];
            whole &= corner != none;
        }
        if (whole) cut.triangles.push_back(triangle);
    }
    body.skin = cut;
}

}  // namespace sulfur::detail
