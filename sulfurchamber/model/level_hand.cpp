#include "level_hand.hpp"

#include <algorithm>
#include <cmath>

#include "words.hpp"
#include "workbench.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

// Marks above a body stand side by side.
int rowPlace(LevelKind kind) {
    switch (kind) {
        case LevelKind::mover:
            return -1;
        case LevelKind::respawn:
            return 1;
        case LevelKind::surface:
            return 2;
        default:
            return 0;
    }
}

bool onBorder(const Bounds& box, const Point& place, double reach) {
    const auto within = [reach](double v, double low, double high) {
        return v > low - reach && v < high + reach;
    };
    if (!within(place.x(), box.low.x(), box.high.x()) ||
        !within(place.y(), box.low.y(), box.high.y()))
        return false;
    const double toSide =
        std::min(std::abs(place.x() - box.low.x()), std::abs(place.x() - box.high.x()));
    const double toEnd =
        std::min(std::abs(place.y() - box.low.y()), std::abs(place.y() - box.high.y()));
    return std::min(toSide, toEnd) <= reach;
}

}  // namespace

Point markOf(const LevelShape& shape, double reach) {
    if (shape.form == LevelShape::Form::rectangle && shape.thing.kind != LevelKind::bounds)
        return shape.at + Point(1.6 * reach, -1.6 * reach);
    if (!infoOf(shape.thing.kind).ofBody) return shape.at;
    return shape.at + Point(2.8 * reach * rowPlace(shape.thing.kind), 2.4 * reach);
}

bool isShown(const Document& document, const LevelThing& thing) {
    if (thing.kind != LevelKind::surface) return true;
    const JsonText text(document.levelText());
    const JsonPath path = pathOf(thing);
    const auto is = [&](const char* member, bool value) {
        return text.boolean(pathOf(path, member)) == value;
    };
    return is("deadly", true) || is("cuts", true) || is("sticky", false) ||
           text.has(pathOf(path, "crumbles")) || text.has(pathOf(path, "deadlySpeed"));
}

std::optional<LevelThing> levelThingAt(const Document& document, const Point& place, double reach,
                                       bool marksOnly) {
    std::optional<LevelThing> nearest;
    double least = 1.5 * reach;
    const auto things = levelThings(document);
    for (const LevelThing& thing : things) {
        if (!isShown(document, thing)) continue;
        const LevelShape shape = shapeOf(document, thing);
        const bool hasMark = shape.form != LevelShape::Form::none &&
                             shape.form != LevelShape::Form::level &&
                             thing.kind != LevelKind::bounds;
        const double distance = (markOf(shape, reach) - place).norm();
        if (!hasMark || distance > least) continue;
        least = distance;
        nearest = thing;
    }
    if (nearest || marksOnly) return nearest;
    for (const LevelThing& thing : things) {
        const LevelShape shape = shapeOf(document, thing);
        const bool rectangle = shape.form == LevelShape::Form::rectangle;
        if (rectangle && onBorder(shape.box, place, reach)) return thing;
        const bool height = shape.form == LevelShape::Form::level;
        if (height && std::abs(place.y() - shape.at.y()) <= reach) return thing;
    }
    return std::nullopt;
}

bool LevelHand::press(const Pointer& pointer) {
    if (!isLevel(bench_.document())) return false;
    from_ = pointer.position;
    moved_ = Point(0, 0);
    changed_ = false;
    return pressHandle(pointer) || pressThing(pointer);
}

bool LevelHand::pressHandle(const Pointer& pointer) {
    for (const LevelThing& thing : bench_.things()) {
        const LevelShape shape = shapeOf(bench_.document(), thing);
        for (std::size_t i = 0; i < shape.handles.size(); ++i) {
            if ((shape.handles[i] - pointer.position).norm() > pointer.reach) continue;
            held_ = thing;
            handle_ = i;
            return true;
        }
    }
    return false;
}

bool LevelHand::pressThing(const Pointer& pointer) {
    const Document& document = bench_.document();
    const bool bodyThere =
        static_cast<bool>(bodyAt(document.world(), pointer.position, pointer.reach));
    const auto thing = levelThingAt(document, pointer.position, pointer.reach, bodyThere);
    if (!thing) return false;
    auto things = bench_.things();
    const bool selected = std::find(things.begin(), things.end(), *thing) != things.end();
    if (pointer.shift || pointer.control) {
        if (selected)
            std::erase(things, *thing);
        else
            things.push_back(*thing);
        bench_.selectThings(std::move(things));
    } else if (!selected) {
        bench_.selectThings({*thing});
    }
    held_ = thing;
    handle_.reset();
    return true;
}

void LevelHand::move(const Pointer& pointer) {
    if (!held_) return;
    Document& document = bench_.document();
    const Point to = bench_.snapped(pointer.position);
    if ((pointer.position - from_).norm() < pointer.reach / 3 && !changed_) return;
    if (!changed_)
        document.begin(tr(handle_ ? "Resize {}" : "Move {}", {titleOf(document, *held_)}));
    changed_ = true;
    if (handle_)
        dragHandle(document, *held_, *handle_, to);
    else
        moveAll(pointer.position - from_);
}

// The thing that is held goes to lines of the grid, the others with it.
void LevelHand::moveAll(const Point& by) {
    Document& document = bench_.document();
    const Point now = shapeOf(document, *held_).at;
    const Point goal = bench_.snapped(now - moved_ + by);
    const Point step = goal - now;
    for (const LevelThing& thing : bench_.things()) moveThing(document, thing, step);
    moved_ += step;
}

void LevelHand::release() {
    if (changed_) bench_.document().commit();
    held_.reset();
    changed_ = false;
}

void LevelHand::cancel() {
    if (changed_) bench_.document().rollback();
    held_.reset();
    changed_ = false;
}

std::string LevelHand::hint() const {
    if (!held_) return "";
    return tr(handle_ ? "Resizing: {}; Escape puts it back" : "Moving: {}; Escape puts it back",
              {titleOf(bench_.document(), *held_)});
}

}  // namespace sulfurchamber
