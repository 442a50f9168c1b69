#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace atlax::detail {

/// Refuses glTF files, plain or binary, at which assimp's reader fails badly: nested deeper than
/// its stack allows, or with base64 that it does not free when it finds a wrong letter in it.
/// Throws Error with `name` and the reason. Any thread.
void checkGltf(std::span<const std::byte> bytes, const std::string& name);

}  // namespace atlax::detail
