// A list of choices for keyboard, mouse and gamepad.
#pragma once

#include <atlax/canvas.hpp>
#include <functional>
#include <quaoar/view/player_actions.hpp>
#include <string>
#include <vector>

namespace quaoar {

struct MenuItem {
    std::string label;
    std::function<void()> run;
};

class Menu {
public:
    /// `selected` is highlighted at first.
    explicit Menu(std::vector<MenuItem> items = {}, std::size_t selected = 0)
        : items_(std::move(items)), selected_(selected < items_.size() ? selected : 0) {}

    /// To be called in every tick. What the player has chosen, to be run by the caller, who may
    /// replace the menu meanwhile; else null.
    std::function<void()> tick(const atlax::ActionState& state, const PlayerActions& actions);
    std::size_t selected() const { return selected_; }

    /// Below `top` pixels, in the middle of the screen.
    void draw(atlax::Canvas& canvas, const atlax::Font& font, float top);

private:
    void move(int step);
    void drawItem(atlax::Canvas& canvas, const atlax::Font& font, std::size_t item, float size);
    /// The item at a place in pixels; items_.size() for none.
    std::size_t under(atlax::Vec2 pixels) const;

    std::vector<MenuItem> items_;
    std::vector<atlax::Rect> places_;  ///< as last drawn, pixels
    std::size_t selected_ = 0;
    atlax::Vec2 pointer_{-1, -1};
    bool pointerSeen_ = false;
};

}  // namespace quaoar
