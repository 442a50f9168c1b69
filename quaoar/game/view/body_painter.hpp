// Everything that moves, apart from hero and rope: crates, jellies, walls, cloth, chains, gears,
// rocks. Dressed in pictures that tear where joints break.
#pragma once

#include <atlax/canvas.hpp>
#include <map>
#include <quaoar/session.hpp>
#include <quaoar/skin/skin_painter.hpp>
#include <quaoar/view/art.hpp>

#include "body_shape.hpp"
#include "look.hpp"

namespace quaoar {

class BodyPainter {
public:
    BodyPainter(Art& art, const Session& session);

    /// All bodies of the world within `view` but the hero, the rope, those in `others`.
    void draw(atlax::Canvas& canvas, atlax::Rect view, double alpha, double seconds,
              const std::vector<sulfur::BodyId>& others);
    /// Joints between bodies, hinges.
    void drawTies(atlax::Canvas& canvas, double alpha);

    /// Found anew when it has changed; valid until the next call.
    const BodyShape& shape(sulfur::BodyId body);

private:
    struct Dress {
        std::string texture;  ///< empty: plain colours
        SkinColors colors;
        bool spikes = false;
    };

    Dress dressOf(const BodyShape& shape, const Surface& surface) const;
    void drawBody(atlax::Canvas& canvas, sulfur::BodyId body, double alpha, double seconds);
    void drawBall(atlax::Canvas& canvas, sulfur::BodyId body, const BodyShape& shape,
                  const Dress& dress, double alpha) const;
    void drawLoose(atlax::Canvas& canvas, const BodyShape& shape, const Dress& dress,
                   const std::vector<atlax::Vec2>& places) const;
    void drawCracks(atlax::Canvas& canvas, const std::vector<atlax::Vec2>& loop, float worn) const;
    void drawHub(atlax::Canvas& canvas, sulfur::BodyId body, const BodyShape& shape,
                 double alpha) const;
    void drawBolt(atlax::Canvas& canvas, atlax::Vec2 at, double seconds);

    Art& art_;
    const Session& session_;
    WorldLook look_;
    std::vector<std::size_t> gears_;  ///< places in the scene of bodies that spin
    std::map<sulfur::BodyId, BodyShape> shapes_;
};

/// Magenta spikes that stand out of a closed border: it kills. Counter-clockwise, metres.
void drawSpikes(atlax::Canvas& canvas, const std::vector<atlax::Vec2>& loop, double seconds);

/// Chevrons that run along a closed border as a conveyor belt does; counter-clockwise, metres.
void drawBelt(atlax::Canvas& canvas, const std::vector<atlax::Vec2>& loop, float speed,
              double seconds, atlax::Color color);

}  // namespace quaoar
