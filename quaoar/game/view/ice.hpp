// Ice: a closed outline drawn as a lit, filled block.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/level.hpp>
#include <quaoar/view/art.hpp>
#include <vector>

namespace quaoar {

/// The drawing of one fixed body, made once: everything is in world coordinates.
class IceView {
public:
    /// `loop`: the middle line of the outline, counter-clockwise, metres; `radius`: half its
    /// thickness.
    IceView(Art& art, const std::vector<atlax::Vec2>& loop, float radius, const Surface& surface,
            const Theme& theme);

    void draw(atlax::Canvas& canvas) const;

private:
    struct Crack {
        std::vector<atlax::Vec2> points;
        float alpha = 0;
    };
    struct Flake {
        atlax::Vec2 from, to;
        float width = 0;
    };

    /// The light that seeps into the ice, as a picture of the distance to its border.
    atlax::Image depthImage() const;
    void addBand(float depth, atlax::Color outer);
    void addFacets(std::uint32_t seed);
    void addIcicles(std::uint32_t seed);
    void addSnow(std::uint32_t seed);
    void addCracks(std::uint32_t seed);
    /// 0 in the shade to 1 in the light, for an outward normal.
    static float light(atlax::Vec2 normal);

    std::vector<atlax::Vec2> loop_;     ///< the outer border
    std::vector<atlax::Vec2> normals_;  ///< at its corners
    atlax::Rect box_;                   ///< around the border, where the level can show it
    atlax::Texture depth_;
    std::vector<atlax::MeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<atlax::MeshVertex> icicles_;
    std::vector<std::uint32_t> icicleIndices_;
    std::vector<Crack> cracks_;
    std::vector<Flake> snow_;
    atlax::Color core_;
    atlax::Color ice_;
    atlax::Color rim_;
};

}  // namespace quaoar
