// Draws what is fitted to bodies: hinges, springs, ropes, zones, thrusters.
#pragma once

#include <atlax/canvas.hpp>
#include <vector>

#include "../model/fitting_marks.hpp"
#include "../model/workbench.hpp"

namespace sulfurchamber {

/// The canvas must be in world space; `pixel` is a logical pixel in metres.
class FittingPainter {
public:
    FittingPainter(atlax::Canvas& canvas, const Workbench& bench, float pixel);

    /// Below bodies.
    void paintZones();
    /// Above them.
    void paintMarks();
    /// Beside those that keys drive.
    void paintKeys(const atlax::Font& font);

private:
    void paintPart();
    void paint(const FittingMark& mark);
    void paintZone(const FittingMark& mark);
    void paintPin(const FittingMark& mark, atlax::Color color);
    void paintTurning(const FittingMark& mark);
    void paintSpring(atlax::Vec2 from, atlax::Vec2 to, atlax::Color color);
    void paintRope(const FittingMark& mark, atlax::Color color);
    void paintRail(const FittingMark& mark, atlax::Color color);
    void paintPulley(const FittingMark& mark, atlax::Color color);
    void paintGear(const FittingMark& mark, atlax::Color color);
    void paintThruster(const FittingMark& mark);
    void paintKey(const std::string& key, atlax::Vec2 low, const atlax::Font& font);
    bool isChosen(const FittingMark& mark) const;

    atlax::Canvas& canvas_;
    const Workbench& bench_;
    float pixel_;
    std::vector<FittingMark> marks_;
};

}  // namespace sulfurchamber
