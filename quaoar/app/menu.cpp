#include "menu.hpp"

#include <quaoar/view/art.hpp>

namespace quaoar {

using atlax::Key;

void Menu::move(int step) {
    const auto count = static_cast<int>(items_.size());
    if (count == 0) return;
    selected_ = static_cast<std::size_t>((static_cast<int>(selected_) + step + count) % count);
}

std::optional<std::size_t> Menu::under(atlax::Vec2 pixels) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].contains(pixels)) return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> Menu::event(const atlax::Event& event) {
    if (const auto* key = std::get_if<atlax::KeyEvent>(&event); key && key->down) {
        if (key->key == Key::Up || key->key == Key::W) move(-1);
        if (key->key == Key::Down || key->key == Key::S) move(1);
        const bool chosen =
            key->key == Key::Enter || key->key == Key::PadEnter || key->key == Key::Space;
        if (chosen && !key->repeat) return selected_;
    }
    if (const auto* moved = std::get_if<atlax::MouseMoved>(&event)) {
        if (const auto item = under(moved->position)) selected_ = *item;
    }
    if (const auto* click = std::get_if<atlax::MouseButtonEvent>(&event)) {
        if (click->down && click->button == atlax::MouseButton::Left) {
            return under(click->position);
        }
    }
    if (const auto* pad = std::get_if<atlax::PadButtonEvent>(&event); pad && pad->down) {
        if (pad->button == atlax::PadButton::DpadUp) move(-1);
        if (pad->button == atlax::PadButton::DpadDown) move(1);
        if (pad->button == atlax::PadButton::South) return selected_;
    }
    return std::nullopt;
}

void Menu::draw(atlax::Canvas& canvas, const atlax::Font& font, float top) {
    const atlax::Vec2 screen = canvas.size().toVec();
    const float unit = screen.y / 720;
    places_.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const atlax::Vec2 middle{screen.x * 0.5f, top + (30 + 60 * static_cast<float>(i)) * unit};
        const atlax::Rect box = atlax::Rect::around(middle, atlax::Vec2{300, 50} * unit);
        places_.push_back(box);
        const bool here = i == selected_;
        canvas.roundedRect(box, 14 * unit, here ? palette::amber : palette::deep.withAlpha(0.8f));
        canvas.roundedRectOutline(box, 14 * unit, (here ? 3.0f : 1.5f) * unit,
                                  here ? palette::glow : palette::ice.withAlpha(0.6f));
        const float edge = box.min.x + 20 * unit;
        if (here) {
            canvas.triangle({edge, middle.y - 7 * unit}, {edge + 11 * unit, middle.y},
                            {edge, middle.y + 7 * unit}, palette::night);
        }
        canvas.text(font, items_[i], middle,
                    {23 * unit, here ? palette::night : palette::frost, atlax::AlignX::Centre,
                     atlax::AlignY::Middle});
    }
}

}  // namespace quaoar
