#pragma once

#include <atlax/canvas.hpp>
#include <vector>

/// What the benchmark draws: 100,000 textured triangles in sheets of 1,000, and 10,000 capsules.
class Load {
public:
    Load();
    void draw(atlax::Canvas& canvas, const atlax::Texture& texture, float angle) const;

private:
    struct Capsule {
        atlax::Vec2 from;
        atlax::Vec2 to;
        atlax::Color color;
    };
    std::vector<atlax::MeshVertex> sheet_;
    std::vector<std::uint32_t> indices_;
    std::vector<Capsule> capsules_;
};
