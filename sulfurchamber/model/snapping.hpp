// Places to which what one draws and moves goes by itself: the grid, corners, centres, angles.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <sulfur/world.hpp>
#include <vector>

namespace sulfurchamber {

/// Which of them count.
struct SnapOptions {
    double grid = 0;       ///< metres between its lines; 0: the grid does not count
    bool corners = false;  ///< of bodies, and ends of ropes and of ground
    bool centres = false;  ///< of mass; of what is fixed the middle of its bounds
    bool angles = false;   ///< directions in steps of 15 degrees
};

/// A place that others go to.
struct SnapPlace {
    enum class Kind : std::uint8_t { grid, corner, centre, angle };
    sulfur::Point at{0, 0};
    Kind kind = Kind::corner;
    sulfur::Point from{0, 0};  ///< of an angle: where its line begins
};

/// Where a point goes, and to what.
struct Snapped {
    sulfur::Point point{0, 0};
    std::optional<SnapPlace> place;
};

/// Whether the places of a body count; nothing: all do.
using SnapCounts = std::function<bool(sulfur::BodyId)>;

/// Corners and centre of a body, as the options ask for them. Corners are those of its outline as
/// if capsules were not round; where a line is bent by less than 20 degrees is none.
std::vector<SnapPlace> snapPlaces(const sulfur::World& world, sulfur::BodyId body,
                                  const SnapOptions& options);
/// Of all bodies that come within `reach` metres of a point.
std::vector<SnapPlace> snapPlacesNear(const sulfur::World& world, const sulfur::Point& point,
                                      double reach, const SnapOptions& options,
                                      const SnapCounts& counts = {});

/// Where a point goes. The nearest corner or centre within `reach` metres comes first, then the
/// grid, then an angle of the line from `from`, within `reach` of the point too.
Snapped snapPoint(const sulfur::World& world, const sulfur::Point& point, double reach,
                  const SnapOptions& options, std::optional<sulfur::Point> from = {},
                  const SnapCounts& counts = {});

/// How far something goes that would be moved by `by`: the nearest of `others` within `reach` of
/// one of its own places, corners to corners and centres to centres; else `own[0]` to the grid.
/// `point` is the way.
Snapped snapMove(std::span<const SnapPlace> own, std::span<const SnapPlace> others,
                 const sulfur::Point& by, double reach, const SnapOptions& options);

/// An angle (radians) in steps of 15 degrees; `within` radians of a step, else unchanged.
double snapAngle(double angle, double within);
inline constexpr double snapAngleStep = 3.14159265358979 / 12;

}  // namespace sulfurchamber
