// Pictures of what levels hold beside bodies: checkpoints, pick-ups, zones, rails, switches.
#pragma once

#include <atlax/canvas.hpp>
#include <quaoar/session.hpp>
#include <quaoar/view/art.hpp>
#include <vector>

#include "look.hpp"

namespace quaoar {

class MechanicsView {
public:
    explicit MechanicsView(const Session& session);

    /// Rails, cables, lamps, wind: behind the bodies.
    void drawBehind(atlax::Canvas& canvas, Art& art, double seconds);
    /// Pick-ups: before them.
    void drawBefore(atlax::Canvas& canvas, Art& art, double seconds);
    /// Behind the ground, which gives the rectangles of their zones a shape.
    void drawLiquids(atlax::Canvas& canvas, atlax::Rect view, double seconds);

private:
    /// A line of light from a switch to what its signal moves.
    struct Cable {
        std::size_t signal = 0;
        std::vector<atlax::Vec2> way;
    };

    void layCables();
    void drawRail(atlax::Canvas& canvas, std::size_t place) const;
    void drawSwitch(atlax::Canvas& canvas, std::size_t place) const;
    void drawCheckpoint(atlax::Canvas& canvas, Art& art, std::size_t place, double seconds) const;
    void drawPickup(atlax::Canvas& canvas, Art& art, std::size_t place, double seconds) const;
    void drawWind(atlax::Canvas& canvas, const Zone& zone, float strength, double seconds) const;
    void drawVent(atlax::Canvas& canvas, const Zone& zone, float strength, double seconds) const;
    void drawGravity(atlax::Canvas& canvas, const Zone& zone, float strength, double seconds) const;
    void drawDeadly(atlax::Canvas& canvas, const Zone& zone, float strength, double seconds) const;
    void drawLiquid(atlax::Canvas& canvas, const Zone& zone, atlax::Rect view, float strength,
                    double seconds) const;

    const Session& session_;
    WorldLook look_;
    std::vector<Cable> cables_;
};

}  // namespace quaoar
