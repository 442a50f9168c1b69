#pragma once

#include <stdexcept>
#include <string>

#include "integrators/integrator.hpp"

namespace sulfur::lab {

/// The integrator of that key.
inline const IntegratorEntry& entryOf(const std::string& key) {
    for (const auto& entry : integrators())
        if (entry.key == key) return entry;
    throw std::out_of_range(key);
}

}  // namespace sulfur::lab
