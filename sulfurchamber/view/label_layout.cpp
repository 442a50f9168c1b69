#include "label_layout.hpp"

#include <algorithm>

namespace sulfurchamber {
namespace {

using atlax::Rect;
using atlax::Vec2;

constexpr float besideMark = 12;  // from its middle
constexpr float betweenPlates = 2;

bool overlap(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x + betweenPlates && b.min.x < a.max().x + betweenPlates &&
           a.min.y < b.max().y + betweenPlates && b.min.y < a.max().y + betweenPlates;
}

bool isIn(const Rect& plate, const Rect& area) {
    return plate.min.x >= area.min.x && plate.min.y >= area.min.y &&
           plate.max().x <= area.max().x && plate.max().y <= area.max().y;
}

// The best first.
std::vector<Rect> placesFor(const Vec2& mark, const Vec2& size) {
    const float left = mark.x - besideMark - size.x, right = mark.x + besideMark;
    const float above = mark.y - besideMark - size.y, below = mark.y + besideMark;
    const Vec2 middle = mark - size * 0.5f;
    std::vector<Rect> places;
    for (const Vec2 min :
         {Vec2{right, middle.y}, Vec2{left, middle.y}, Vec2{middle.x, below}, Vec2{middle.x, above},
          Vec2{right, below}, Vec2{right, above}, Vec2{left, below}, Vec2{left, above}})
        places.push_back({min, size});
    return places;
}

Rect movedInto(const Rect& area, Rect plate) {
    const Vec2 last = area.max() - plate.size;
    plate.min.x = std::max(area.min.x, std::min(plate.min.x, last.x));
    plate.min.y = std::max(area.min.y, std::min(plate.min.y, last.y));
    return plate;
}

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(std::span<const LabelWish> wishes,
                                                   const Rect& area, std::span<const Rect> taken) {
    std::vector<Rect> full(taken.begin(), taken.end());
    std::vector<std::optional<LabelPlace>> placed;
    const auto find = [&](const Vec2& mark, const Vec2& size) -> std::optional<Rect> {
        const std::vector<Rect> places = placesFor(mark, size);
        const auto found = std::find_if(places.begin(), places.end(), [&](const Rect& place) {
            return isIn(place, area) && std::none_of(full.begin(), full.end(), [&](const Rect& r) {
                       return overlap(r, place);
                   });
        });
        return found == places.end() ? std::nullopt : std::optional(*found);
    };
    for (const LabelWish& wish : wishes) {
        placed.emplace_back();
        if (!area.contains(wish.mark)) continue;
        if (const auto whole = find(wish.mark, wish.size))
            placed.back() = {*whole, false};
        else if (wish.needed)
            placed.back() = {movedInto(area, placesFor(wish.mark, wish.size).front()), false};
        else if (const auto part = find(wish.mark, wish.shorter))
            placed.back() = {*part, true};
        if (placed.back()) full.push_back(placed.back()->plate);
    }
    return placed;
}

}  // namespace sulfurchamber
