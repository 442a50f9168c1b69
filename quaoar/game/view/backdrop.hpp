// What lies behind the playing field: sky, far layers, and what drifts before and behind the ice.
#pragma once

#include <quaoar/level.hpp>
#include <quaoar/view/art.hpp>
#include <quaoar/view/quality.hpp>
#include <vector>

#include "look.hpp"

namespace quaoar {

/// Something far away that moves with only a share of the camera: a mesh, lines on its edges,
/// lights and wheels on it. Metres.
struct BackdropLayer {
    struct Lamp {
        atlax::Vec2 at;
        float size = 0.1f, phase = 0;
        atlax::Color color;
    };
    struct Wheel {
        atlax::Vec2 at;
        float radius = 1, speed = 0.2f;  ///< rad/s
        int teeth = 12;
        atlax::Color color;
    };
    float parallax = 0;
    std::vector<atlax::MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::vector<atlax::Vec2>> edges;
    atlax::Color edgeColor;
    std::vector<Lamp> lamps;
    std::vector<Wheel> wheels;
};

/// The layers of a world from far to near, around the place where all of them meet.
std::vector<BackdropLayer> makeLayers(const Theme& theme, atlax::Vec2 anchor, float width);

class Backdrop {
public:
    explicit Backdrop(const Level& level);

    /// Everything behind the playing field. `seconds` moves stars, wheels and mist. Where the
    /// quality says so, it is drawn smaller and stretched.
    void drawBehind(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera, double seconds,
                    const Quality& quality);
    /// What drifts behind the ice or, few and large, before everything.
    void drawWeather(atlax::Canvas& canvas, const atlax::Camera& camera, double seconds,
                     bool before, const Quality& quality) const;
    /// Dark shapes close to the eye, at the lower and upper edge of the picture.
    void drawForeground(atlax::Canvas& canvas, const atlax::Camera& camera) const;

private:
    struct Star {
        atlax::Vec2 place;  ///< 0..1 of the screen
        float size, phase, brightness;
    };

    void drawBlade(atlax::Canvas& canvas, atlax::Vec2 root, float size, float lean,
                   atlax::Color dark) const;
    void drawAll(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera, double seconds);
    void drawSky(atlax::Canvas& canvas, Art& art, double seconds) const;
    void drawStars(atlax::Canvas& canvas, Art& art, double seconds) const;
    void drawRing(atlax::Canvas& canvas) const;
    void drawShafts(atlax::Canvas& canvas, double seconds) const;
    void drawLayer(atlax::Canvas& canvas, Art& art, const BackdropLayer& layer,
                   double seconds) const;

    Theme theme_;
    WorldLook look_;
    atlax::Vec2 anchor_;  ///< where all layers meet: the middle of the level
    std::vector<Star> stars_;
    std::vector<BackdropLayer> layers_;
    atlax::RenderTarget small_;
};

}  // namespace quaoar
