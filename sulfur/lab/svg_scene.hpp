// A world as an SVG picture.
#pragma once

#include <string>
#include <sulfur/sulfur.hpp>
#include <utility>
#include <vector>

namespace sulfur::lab {

/// What collides, with its true thickness (fixed bodies grey, sleeping ones pale), other joints as
/// thin lines, and contacts of the last tick as red dots.
std::string drawScene(const World& world, const std::string& title);

/// Pictures of scenes, each with the name of its file, without a folder.
class Album {
public:
    /// Draws `world`. `name` becomes part of the file's name: letters, digits and dashes.
    void add(const std::string& name, const World& world) {
        pictures.emplace_back("scene_" + name + ".svg", drawScene(world, name));
    }

    std::vector<std::pair<std::string, std::string>> pictures;
};

}  // namespace sulfur::lab
