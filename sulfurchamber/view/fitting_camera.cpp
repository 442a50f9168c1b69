#include "fitting_camera.hpp"

#include <algorithm>

#include "../model/geometry.hpp"
#include "../model/level_things.hpp"

namespace sulfurchamber {
namespace {

constexpr float leastZoom = 0.5f;  // pixels per metre
constexpr float mostZoom = 20000;
constexpr float sceneMargin = 1.25f;  // of what is shown around what is interesting
constexpr double smallestShown = 4;   // metres that are shown at least
constexpr float emptyWidth = 12;      // metres that an empty scene shows
constexpr float emptyFloor = 0.2f;    // of the height that is below its floor

}  // namespace

atlax::Camera fittingCamera(const Document& document, atlax::PixelSize size,
                            const std::optional<Bounds>& wanted) {
    const float width = std::max(64.0f, static_cast<float>(size.width));
    const float height = std::max(64.0f, static_cast<float>(size.height));
    atlax::Camera camera;
    auto interesting = interestingBounds(document.world());
    // Of a level, what the player can see.
    if (isLevel(document)) {
        const LevelShape bounds = shapeOf(document, {LevelKind::bounds, 0, {}});
        if (bounds.form == LevelShape::Form::rectangle) interesting = bounds.box;
    }
    if (wanted) interesting = wanted;
    if (!interesting) {
        // Room to build: the floor in the lower fifth.
        camera.pixelsPerMetre = width / emptyWidth;
        const float above = (0.5f - emptyFloor) * height / camera.pixelsPerMetre;
        camera.centre = {0, static_cast<float>(floorHeight(document.world())) + above};
        return camera;
    }
    const auto extent = [](double length) {
        return static_cast<float>(std::max(smallestShown, length)) * sceneMargin;
    };
    const sulfur::Point shown = interesting->size();
    camera.pixelsPerMetre = std::clamp(
        std::min(width / extent(shown.x()), height / extent(shown.y())), leastZoom, mostZoom);
    camera.centre = atlax::Vec2(interesting->centre());
    return camera;
}

}  // namespace sulfurchamber
