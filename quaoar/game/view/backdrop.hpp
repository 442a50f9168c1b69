// What lies behind the playing field: sky, stars, Quaoar's ring, its moon, ridges of ice, snow.
#pragma once

#include <quaoar/level.hpp>
#include <quaoar/view/art.hpp>
#include <vector>

namespace quaoar {

class Backdrop {
public:
    explicit Backdrop(const Level& level);

    /// Everything behind the playing field. `seconds` moves stars and mist.
    void drawBehind(atlax::Canvas& canvas, Art& art, const atlax::Camera& camera, double seconds);
    /// Ice crystals that drift behind the ice or, few and large, before everything.
    void drawSnow(atlax::Canvas& canvas, const atlax::Camera& camera, double seconds,
                  bool before) const;

private:
    struct Star {
        atlax::Vec2 place;  ///< 0..1 of the screen
        float size, phase, brightness;
    };
    /// A line of mountains as a strip of quads, darker towards the foot.
    struct Ridge {
        float parallax = 0;
        std::vector<atlax::Vec2> crest;
        std::vector<atlax::MeshVertex> vertices;
        std::vector<std::uint32_t> indices;
        atlax::Color rim;
    };

    void makeRidge(float parallax, float base, float height, float step, atlax::Color top,
                   atlax::Color foot, std::uint32_t seed);
    void drawSky(atlax::Canvas& canvas, Art& art, double seconds) const;
    void drawRing(atlax::Canvas& canvas) const;

    Theme theme_;
    atlax::Vec2 anchor_;  ///< where all layers meet: the middle of the level
    float width_ = 0;
    std::vector<Star> stars_;
    std::vector<Ridge> ridges_;
};

}  // namespace quaoar
