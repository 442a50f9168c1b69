#include "shape/materials.hpp"

namespace sulfur::detail {

const Material& surfaceOf(const State& state, std::uint32_t joint, std::uint32_t body) {
    if (joint != none && state.joints.ownMaterial[joint]) return state.joints.material[joint];
    return state.bodies[body].material;
}

}  // namespace sulfur::detail
