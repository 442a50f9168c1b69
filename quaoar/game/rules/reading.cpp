#include "reading.hpp"

namespace quaoar::reading {

using sulfur::scene::Node;

void refuseUnknown(const Node& object, std::initializer_list<std::string_view> known) {
    object.requireObject();
    for (const Node& member : object.members()) {
        bool found = false;
        for (const std::string_view key : known) found = found || key == member.key();
        if (found) continue;
        std::string allowed;
        for (const std::string_view key : known) {
            allowed += (allowed.empty() ? "" : ", ") + std::string(key);
        }
        member.fail("is not known here; allowed are " + allowed);
    }
}

void requireInside(const Node& node, const Level& level, const sulfur::Point& place) {
    const bool inside = place.x() >= level.boundsMin.x() && place.x() <= level.boundsMax.x() &&
                        place.y() >= level.boundsMin.y() && place.y() <= level.boundsMax.y();
    if (!inside) node.fail("lies outside of the level; allowed is a place within \"bounds\"");
}

std::string signalName(const Node& node) {
    return node.string(1, 60);
}

}  // namespace quaoar::reading
