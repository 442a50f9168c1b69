// Monsters: a picture on their live particles, and eyes that show what they mean to do.
#pragma once

#include <atlax/canvas.hpp>
#include <map>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>

#include "body_painter.hpp"

namespace quaoar {

class MonsterView {
public:
    MonsterView(Art& art, const Session& session, BodyPainter& painter);

    /// Their bodies, which the painter leaves to this class.
    const std::vector<sulfur::BodyId>& bodies() const { return bodies_; }
    void draw(atlax::Canvas& canvas, double alpha, double seconds);

private:
    /// Of the middle of its body, as it is drawn.
    struct Frame {
        atlax::Vec2 middle, size;
        atlax::Vec2 looks;  ///< towards the hero, unit length
        float alarm = 0;    ///< 0: at peace, 1: in a rage
        bool defeated = false;
        float facing = 1;  ///< -1: to the left
    };

    Frame frameOf(std::size_t place, const std::vector<atlax::Vec2>& border) const;
    void drawBody(atlax::Canvas& canvas, const Monster& monster, const BodyShape& shape,
                  const std::vector<atlax::Vec2>& places, double seconds) const;
    void drawSlug(atlax::Canvas& canvas, const Frame& frame, const std::vector<atlax::Vec2>& border,
                  double seconds) const;
    void drawLeech(atlax::Canvas& canvas, const Frame& frame,
                   const std::vector<atlax::Vec2>& border, double seconds) const;
    void drawWarden(atlax::Canvas& canvas, const Frame& frame,
                    const std::vector<atlax::Vec2>& border, double seconds) const;
    void drawEye(atlax::Canvas& canvas, atlax::Vec2 at, float radius, const Frame& frame,
                 float side, atlax::Color iris) const;

    Art& art_;
    const Session& session_;
    BodyPainter& painter_;
    std::vector<sulfur::BodyId> bodies_;
};

}  // namespace quaoar
