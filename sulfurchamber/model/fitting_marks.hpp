// Where fittings are seen and hit in this moment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document.hpp"

namespace sulfurchamber {

/// How one looks.
struct FittingMark {
    enum class Shape : std::uint8_t {
        hinge,
        motor,
        weld,
        spring,
        cable,
        winch,
        slider,
        axle,
        pulley,
        gear,
        thruster,
        zone,
        wind
    };
    FittingRef ref;
    Shape shape = Shape::hinge;
    /// Metres. Of a spring and its like both ends, of a slider the line of the rail and then what
    /// slides, of a pulley the rope, of a gear both parts, of a zone two corners.
    std::vector<sulfur::Point> points;
    /// Of a thruster, newtons; of a zone, m/s or m/s^2; of a motor (speed, 0).
    sulfur::Vec2 direction{0, 0};
    double length = 0;  ///< metres, of a cable or winch; may be infinite
    DriveKeys keys;
    /// Where it is hit, and where its keys stand.
    sulfur::Point at{0, 0};
};

/// Those that are there in this moment, zones first.
std::vector<FittingMark> fittingMarks(const Document& document);
/// The one that the pointer hits: points before lines, lines before borders of zones.
std::optional<FittingRef> fittingAt(const Document& document, const sulfur::Point& point,
                                    double reach);
/// The particle or joint of a body that the pointer hits, particles before joints; of null a joint
/// between two.
std::optional<FittingRef> partAt(const Document& document, sulfur::BodyId body,
                                 const sulfur::Point& point, double reach);
/// Springs, cables and winches that a line from `a` to `b` crosses, in the order of the plan.
std::vector<FittingRef> fittingsCrossing(const Document& document, const sulfur::Point& a,
                                         const sulfur::Point& b);
/// Moves one by metres, as a part of the open edit: a zone, a thruster or a particle within its
/// body, or a mechanism with its pegs. Joints stay. Of what has two ends the one that is nearer to `from`.
void moveFitting(Document& document, const FittingRef& ref, const sulfur::Point& from,
                 const sulfur::Point& by);

}  // namespace sulfurchamber
