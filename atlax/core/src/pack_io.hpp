#pragma once

#include <atlax/pack.hpp>

namespace atlax {

/// Lets PhysicsFS read the pack through the very source that was checked, under the name `mounted`.
/// Throws Error.
void mountPackIo(const Pack& pack, const std::string& mounted, const std::string& place);

}  // namespace atlax
