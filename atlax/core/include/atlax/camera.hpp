#pragma once

#include <atlax/vec.hpp>

namespace atlax {

/// How world space (metres, y up) appears on a canvas (pixels, y down). A plain value: any
/// thread, nothing throws.
struct Camera {
    Vec2 centre;                 ///< metres; appears in the middle of the canvas
    float pixelsPerMetre = 100;  ///< must be positive

    /// A camera that shows this many metres over the height of the canvas.
    static Camera withHeight(Vec2 centre, float metres, PixelSize canvas) {
        return {centre, static_cast<float>(canvas.height) / metres};
    }

    /// For a layer that moves with only this share of the camera's movement away from `anchor`:
    /// 1 is the playing field, 0.2 a far mountain, 0 the sky.
    Camera parallax(float factor, Vec2 anchor = {}) const {
        return {anchor + (centre - anchor) * factor, pixelsPerMetre};
    }

    Vec2 toScreen(Vec2 world, PixelSize canvas) const {
        return {canvas.toVec().x * 0.5f + (world.x - centre.x) * pixelsPerMetre,
                canvas.toVec().y * 0.5f - (world.y - centre.y) * pixelsPerMetre};
    }
    Vec2 toWorld(Vec2 screen, PixelSize canvas) const {
        return {centre.x + (screen.x - canvas.toVec().x * 0.5f) / pixelsPerMetre,
                centre.y - (screen.y - canvas.toVec().y * 0.5f) / pixelsPerMetre};
    }
    /// The part of the world that is seen.
    Rect view(PixelSize canvas) const {
        return Rect::around(centre, canvas.toVec() / pixelsPerMetre);
    }
};

}  // namespace atlax
