// Bodies from outlines that were drawn elsewhere.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"
#include "region.hpp"

namespace sulfurchamber {

/// What a region becomes.
enum class OutlineKind : std::uint8_t { rigid, soft, fixed };
/// "rigid", "soft", "fixed"; nothing for other names.
std::optional<OutlineKind> outlineKindFromName(std::string_view name);

/// A region with what it is called and how it looks.
struct DrawnShape {
    std::string name;
    Region region;
    std::string colour = {};  ///< "#rrggbb", or empty: none of its own
};

/// A body of a region, in the region's frame: a polygon, which is rigid or fixed, or a lattice of
/// springs. Thin slits lead to its holes. Corners are left out where there are more than 200, the
/// least important first. Throws std::runtime_error when the region crosses itself or has no room
/// for a body.
sulfur::scene::Prefab bodyOf(const Region& region, OutlineKind kind);

/// Adds a body of each shape, `place` being where the shapes' origin comes to lie, as a part of the
/// open edit. Those of which no body can be made are left out and told in `leftOut`. Throws
/// std::runtime_error when none can.
std::vector<sulfur::BodyId> addShapes(Document& document, const std::vector<DrawnShape>& shapes,
                                      OutlineKind kind, const sulfur::Point& place,
                                      std::vector<std::string>& leftOut);

}  // namespace sulfurchamber
