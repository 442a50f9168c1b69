// A list or a grid of choices for keyboard, mouse and gamepad.
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
    /// For what has values: one on (1) or back (-1), by the keys for left and right.
    std::function<void(int)> change = {};
    /// Drawn dimmer: what cannot be chosen, or not yet.
    bool dim = false;
};

class Menu {
public:
    /// `selected` is highlighted at first. With more than one column, left and right go from item
    /// to item, and up and down from row to row.
    explicit Menu(std::vector<MenuItem> items = {}, std::size_t selected = 0, int columns = 1)
        : items_(std::move(items)),
          selected_(selected < items_.size() ? selected : 0),
          columns_(columns) {}

    /// To be called in every tick. What the player has chosen, to be run by the caller, who may
    /// replace the menu meanwhile; else null.
    std::function<void()> tick(const atlax::ActionState& state, const PlayerActions& actions);
    std::size_t selected() const { return selected_; }
    std::size_t size() const { return items_.size(); }
    void setColumns(int columns) { columns_ = columns; }

    /// A list from `top` to `bottom` pixels at most, in the middle of the screen.
    void draw(atlax::Canvas& canvas, const atlax::Font& font, float top, float bottom);
    /// For a grid: where each item was drawn by the caller, pixels.
    void place(std::vector<atlax::Rect> places) { places_ = std::move(places); }

private:
    void move(int step);
    void drawItem(atlax::Canvas& canvas, const atlax::Font& font, std::size_t item, float size);
    /// The item at a place in pixels; items_.size() for none.
    std::size_t under(atlax::Vec2 pixels) const;

    std::vector<MenuItem> items_;
    std::vector<atlax::Rect> places_;  ///< as last drawn, pixels
    std::size_t selected_ = 0;
    int columns_ = 1;
    atlax::Vec2 pointer_{-1, -1};
    bool pointerSeen_ = false;
};

}  // namespace quaoar
