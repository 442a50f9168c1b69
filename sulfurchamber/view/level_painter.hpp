// The marks of a level over its picture: spawn, exit, zones, ways, texts.
#pragma once

#include <atlax/canvas.hpp>
#include <atlax/font.hpp>
#include <functional>
#include <string>
#include <vector>

#include "../model/level_things.hpp"
#include "../model/workbench.hpp"

namespace sulfurchamber {

/// Keeps what it has read of the level between frames.
class LevelPainter {
public:
    /// Draws in world space through this camera, then texts in screen space. Nothing where the
    /// scene is no level.
    void paint(atlax::Canvas& canvas, const atlax::Camera& camera, const atlax::Font& font,
               const Workbench& bench);

private:
    void read(const Document& document);
    void paintOutside(const Bounds& box);
    void paintShape(const LevelShape& shape, bool selected);
    void paintBox(const LevelShape& shape, atlax::Color color, bool selected);
    void paintWay(const LevelShape& shape, atlax::Color color);
    void paintMark(const LevelShape& shape, atlax::Color color, bool selected);
    void paintGlyph(LevelKind kind, atlax::Vec2 at, atlax::Color color);
    void paintHandles(const LevelShape& shape);
    struct Text {
        std::string words;    ///< with line breaks
        std::string shorter;  ///< where there is little room
        float size = 0;       ///< logical pixels
        atlax::Color color;
        atlax::Vec2 extent(const atlax::Font& font, const std::string& what) const;
    };
    using ShapeTest = std::function<bool(const LevelShape&)>;
    void paintTexts(const atlax::Camera& camera, const atlax::Font& font,
                    const ShapeTest& isSelected, const ShapeTest& isNamed);
    static Text textOf(const LevelShape& shape, const atlax::Font& font, bool selected,
                       float viewWidth);

    std::vector<LevelShape> shapes_;
    std::uint64_t revision_ = 0;
    // Of the frame that is being painted.
    atlax::Canvas* canvas_ = nullptr;
    float pixel_ = 0.01f;  ///< one logical pixel in metres
};

/// The colour of a kind in the picture and in lists.
atlax::Color colourOf(LevelKind kind);

}  // namespace sulfurchamber
