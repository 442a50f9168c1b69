// Where texts stand beside their marks so that none covers another. Knows no canvas.
#pragma once

#include <atlax/vec.hpp>
#include <optional>
#include <span>
#include <vector>

namespace sulfurchamber {

/// A text beside a mark, in one unit, y down.
struct LabelWish {
    atlax::Vec2 mark;     ///< the middle of what it names
    atlax::Vec2 size;     ///< of its plate
    atlax::Vec2 shorter;  ///< of the plate of a shorter text
    bool needed = false;  ///< whether it stands over what is taken rather than nowhere
};

struct LabelPlace {
    atlax::Rect plate;
    bool isShort = false;
    bool operator==(const LabelPlace&) const = default;
};

/// The first wishes first: at the right of their marks, else at the left, below or above, within
/// `area` and beside what is `taken`; where there is no room, the shorter text. Nothing for what
/// has no room either way, and for marks that are out of `area`.
std::vector<std::optional<LabelPlace>> placeLabels(std::span<const LabelWish> wishes,
                                                   const atlax::Rect& area,
                                                   std::span<const atlax::Rect> taken);

}  // namespace sulfurchamber
