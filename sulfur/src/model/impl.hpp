// What World hides.
#pragma once

#include <sulfur/world.hpp>

#include "model/state.hpp"

namespace sulfur {

struct World::Impl {
    detail::State state;
};

}  // namespace sulfur
