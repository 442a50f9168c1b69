// Scenes of R.U.B.E., the editor for Box2D, as scenes of our own.
#pragma once

#include <filesystem>
#include <string>
#include <sulfur/scene.hpp>
#include <vector>

namespace sulfurchamber {

struct RubeScene {
    sulfur::scene::Scene scene;
    std::vector<std::string>
        leftOut;  ///< what has no counterpart, each once, in the user's language
};

/// Reads the JSON that R.U.B.E. exports. A body with several fixtures becomes as many bodies, which
/// welds hold together; joints become mechanisms. Throws sulfur::scene::ReadError when the file
/// cannot be read or is none of these.
RubeScene readRube(const std::filesystem::path& file);

}  // namespace sulfurchamber
