// What guides a beginner, drawn over the scene: the film of a tool, the hand of a lesson, and what
// to do with an empty scene.
#pragma once

#include <atlax/canvas.hpp>
#include <memory>
#include <optional>
#include <string>

#include "../model/tool_demo.hpp"
#include "scene_painter.hpp"

namespace sulfurchamber {

class GuideOverlay {
public:
    /// Shows the film of this tool, from its beginning, until told otherwise, and its name.
    void showFilm(std::optional<ToolKind> tool, std::string name = {});
    std::optional<ToolKind> film() const;
    /// Draws a hand at a place of the scene, metres.
    void showHand(std::optional<sulfur::Point> place, bool pressed);

    /// Whether a film or a hand is shown.
    bool moves() const { return film_ != nullptr || hand_.has_value(); }

    /// After the scene; leaves the canvas in screen space. `camera` is the scene's, `inset` what
    /// rulers take at the left, logical pixels, and `seconds` the time since the last frame.
    void paint(atlax::Canvas& canvas, const atlax::Font& font, const Workbench& bench,
               const atlax::Camera& camera, float inset, double seconds);

private:
    void paintFilm(atlax::Canvas& canvas, const atlax::Font& font, float inset);

    std::unique_ptr<ToolDemo> film_;
    std::string filmName_;
    ScenePainter painter_;  // of the film
    std::optional<sulfur::Point> hand_;
    bool handPressed_ = false;
};

/// What an empty scene says; empty for one in which something is, or was done.
std::string invitation(const Document& document);

}  // namespace sulfurchamber
