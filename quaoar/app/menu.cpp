#include "menu.hpp"

#include <algorithm>
#include <quaoar/view/art.hpp>

namespace quaoar {

/// Lists go round; in a grid, what has nobody beside it stays.
void Menu::move(int step) {
    const auto count = static_cast<int>(items_.size());
    if (count == 0) return;
    const int next = static_cast<int>(selected_) + step;
    if (columns_ > 1 && (next < 0 || next >= count)) return;
    selected_ = static_cast<std::size_t>((next % count + count) % count);
}

std::size_t Menu::under(atlax::Vec2 pixels) const {
    const auto found = std::find_if(places_.begin(), places_.end(),
                                    [&](const atlax::Rect& r) { return r.contains(pixels); });
    return found == places_.end() ? items_.size()
                                  : static_cast<std::size_t>(found - places_.begin());
}

std::function<void()> Menu::tick(const atlax::ActionState& state, const PlayerActions& actions) {
    const atlax::Vec2 pointer{static_cast<float>(state.pointerX),
                              static_cast<float>(state.pointerY)};
    const std::size_t here = under(pointer);
    // A mouse that lies still leaves the choice to the keys.
    if (pointerSeen_ && !(pointer == pointer_) && here < items_.size()) selected_ = here;
    pointer_ = pointer;
    pointerSeen_ = true;
    const int down = state.pressCount(actions.menuDown) - state.pressCount(actions.menuUp);
    const int right = state.pressCount(actions.menuRight) - state.pressCount(actions.menuLeft);
    move(down * columns_);
    if (columns_ > 1) move(right);
    if (state.wasPressed(actions.click) && here < items_.size()) {
        selected_ = here;
        return items_[here].run;
    }
    if (selected_ >= items_.size()) return {};
    if (state.wasPressed(actions.choose)) return items_[selected_].run;
    if (right == 0 || !items_[selected_].change) return {};
    return [change = items_[selected_].change, right] { change(right); };
}

void Menu::drawItem(atlax::Canvas& canvas, const atlax::Font& font, std::size_t item, float size) {
    const atlax::Rect box = places_[item];
    const float unit = size / 23;
    const bool here = item == selected_;
    canvas.roundedRect(box, 14 * unit, here ? palette::amber : palette::deep.withAlpha(0.8f));
    canvas.roundedRectOutline(box, 14 * unit, (here ? 3.0f : 1.5f) * unit,
                              here ? palette::glow : palette::ice.withAlpha(0.6f));
    const float edge = box.min.x + 20 * unit;
    const float middle = box.min.y + box.size.y * 0.5f;
    if (here) {
        canvas.triangle({edge, middle - 7 * unit}, {edge + 11 * unit, middle},
                        {edge, middle + 7 * unit}, palette::night);
    }
    const float width = canvas.measure(font, items_[item].label, size).width;
    const float room = box.size.x - 76 * unit;
    canvas.text(font, items_[item].label, {box.min.x + box.size.x * 0.5f, middle},
                {width > room ? size * room / width : size,
                 (here ? palette::night : palette::frost).withAlpha(items_[item].dim ? 0.5f : 1.0f),
                 atlax::AlignX::Centre, atlax::AlignY::Middle});
}

void Menu::draw(atlax::Canvas& canvas, const atlax::Font& font, float top, float bottom) {
    canvas.setScreenSpace();
    const atlax::Vec2 screen = canvas.size().toVec();
    const auto count = static_cast<float>(items_.size());
    // Long lists are set closer.
    const float unit = std::min(std::min(screen.y / 720, screen.x / 600),
                                (bottom - top) / std::max(58 * count, 1.0f));
    const float size = 25 * unit;
    float width = 300 * unit;
    for (const MenuItem& item : items_)
        width = std::max(width, canvas.measure(font, item.label, size).width + 90 * unit);
    width = std::min(width, 0.94f * screen.x);
    places_.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const atlax::Vec2 middle{screen.x * 0.5f, top + (29 + 58 * static_cast<float>(i)) * unit};
        places_.push_back(atlax::Rect::around(middle, {width, 50 * unit}));
        drawItem(canvas, font, i, size);
    }
}

}  // namespace quaoar
