// A list of choices for keyboard, mouse and gamepad.
#pragma once

#include <atlax/canvas.hpp>
#include <atlax/event.hpp>
#include <optional>
#include <string>
#include <vector>

namespace quaoar {

class Menu {
public:
    explicit Menu(std::vector<std::string> items = {}) : items_(std::move(items)) {}

    /// The item that the event chose, counted from 0. Enter, Space, a click and South choose;
    /// arrows, W and S, the mouse and the pad's cross move.
    std::optional<std::size_t> event(const atlax::Event& event);

    /// Below `top` pixels, in the middle of the screen.
    void draw(atlax::Canvas& canvas, const atlax::Font& font, float top);

private:
    void move(int step);
    std::optional<std::size_t> under(atlax::Vec2 pixels) const;

    std::vector<std::string> items_;
    std::vector<atlax::Rect> places_;  ///< as last drawn, pixels
    std::size_t selected_ = 0;
};

}  // namespace quaoar
