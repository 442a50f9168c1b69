// The ground: closed outlines of fixed bodies drawn as lit, filled blocks of their world's
// material.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/level.hpp>
#include <quaoar/view/art.hpp>
#include <vector>

#include "look.hpp"

namespace quaoar {

/// All that decides how a block looks.
struct IceMould {
    std::vector<atlax::Vec2> loop;  ///< metres, the outline's middle line, counter-clockwise
    float radius = 0;               ///< metres, half of its thickness
    Surface surface;
    Theme theme;
    atlax::Rect shown;  ///< the part of the world that the camera may show

    friend bool operator==(const IceMould&, const IceMould&) = default;
};

/// The drawing of one fixed body, made once: everything is in world coordinates.
class IceView {
public:
    IceView(Art& art, const IceMould& mould);
    const IceMould& mould() const { return mould_; }

    /// `view`: what the camera shows, metres; nothing else is drawn.
    void draw(atlax::Canvas& canvas, Art& art, atlax::Rect view) const;
    /// Spikes or belts on its border.
    void drawTrim(atlax::Canvas& canvas, float surfaceSpeed, double seconds) const;
    /// The light of a lamp on border and glints near it, additive.
    void drawLit(atlax::Canvas& canvas, atlax::Vec2 lamp, float reach, atlax::Color light) const;

private:
    struct Crack {
        std::vector<atlax::Vec2> points;
        float alpha = 0;
    };
    /// A piece of what lies on the border: snow, moss, plates.
    struct Cap {
        atlax::Vec2 from, to;
        float width = 0;
        atlax::Color color;
    };
    /// A short piece of the border.
    struct Piece {
        atlax::Vec2 from, to, normal;
    };
    /// Something in the rock that catches light.
    struct Glint {
        atlax::Vec2 at;
        float size = 0;
    };

    void chooseColours(const Surface& surface, const Theme& theme);
    void addBand(float from, float depth, atlax::Color outer, bool evenly);
    void addFacets(std::uint32_t seed);
    void addIcicles(std::uint32_t seed);
    void addCaps(std::uint32_t seed);
    void addCracks(std::uint32_t seed);
    void addPlates(std::uint32_t seed);
    void addPieces(std::uint32_t seed);

    IceMould mould_;
    std::vector<atlax::Vec2> loop_;     ///< the outer border
    std::vector<atlax::Vec2> normals_;  ///< at its corners
    atlax::Rect box_;                   ///< around the border, where the level can show it
    atlax::Texture inside_;
    std::vector<atlax::MeshVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<atlax::MeshVertex> icicles_;
    std::vector<std::uint32_t> icicleIndices_;
    std::vector<Crack> cracks_;
    std::vector<Cap> drips_, caps_;  ///< those below first
    std::vector<Piece> pieces_;
    std::vector<Glint> glints_;
    WorldLook look_;
    Theme::World world_;
    Surface surface_;
    atlax::Color core_;
    atlax::Color ice_;
    atlax::Color rim_;
};

}  // namespace quaoar
