// What a file holds, as far as its first bytes tell: its name may be wrong.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sulfurchamber {

enum class FileKind : std::uint8_t {
    other,
    scene,      ///< a scene or a level
    blueprint,  ///< a file of one blueprint
    drawing,    ///< SVG
    picture,    ///< PNG or JPEG
    rube,       ///< a scene of R.U.B.E., the editor for Box2D
};

/// Of these first bytes of a file.
FileKind kindOfBytes(std::string_view head);
/// Reads some kilobytes. Throws std::runtime_error when the file cannot be read.
FileKind kindOfFile(const std::filesystem::path& file);

}  // namespace sulfurchamber
