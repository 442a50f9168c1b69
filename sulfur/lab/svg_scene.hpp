// A world as an SVG picture.
#pragma once

#include <algorithm>
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
    /// Draws `world`. `name` becomes part of the file's name, with dashes for spaces.
    void add(const std::string& name, const World& world) {
        std::string file = "scene_" + name + ".svg";
        std::replace(file.begin(), file.end(), ' ', '-');
        pictures.emplace_back(std::move(file), drawScene(world, name));
    }

    std::vector<std::pair<std::string, std::string>> pictures;
};

}  // namespace sulfur::lab
