#include "hand.hpp"

#include <algorithm>
#include <utility>

namespace sulfurchamber {

using sulfur::Point;

namespace hand {

using Act = HandMove::Act;

HandMoves operator+(HandMoves first, const HandMoves& then) {
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

HandMoves take(ToolKind tool) {
    return {{.act = Act::tool, .chosen = tool}};
}

HandMoves glide(const Point& to, double seconds) {
    return {{.act = Act::glide, .seconds = seconds, .to = to}};
}

HandMoves click(const Point& at, bool shift) {
    return glide(at, 0.25) + HandMoves{{.act = Act::press, .seconds = 0.08, .shift = shift},
                                       {.act = Act::release, .seconds = 0.08, .shift = shift}};
}

HandMoves drag(const Point& from, const Point& to, bool shift) {
    return glide(from, 0.25) + HandMoves{{.act = Act::press, .seconds = 0.05, .shift = shift},
                                         {.act = Act::glide, .seconds = 0.45, .to = to},
                                         {.act = Act::release, .seconds = 0.1, .shift = shift}};
}

HandMoves stroke(const std::vector<Point>& points) {
    HandMoves moves = glide(points.front(), 0.2) + HandMoves{{.act = Act::press, .seconds = 0.02}};
    for (const Point& point : points) moves = std::move(moves) + glide(point, 0.035);
    return std::move(moves) + HandMoves{{.act = Act::release, .seconds = 0.1}};
}

HandMoves act(const std::string& name, double seconds) {
    return {{.act = Act::action, .seconds = seconds, .name = name}};
}

HandMoves rest(double seconds) {
    return {{.act = Act::rest, .seconds = seconds}};
}

}  // namespace hand

Hand::Hand(Workbench& bench, HandMoves moves, std::function<void(const std::string&)> act)
    : bench_(&bench), moves_(std::move(moves)), act_(std::move(act)) {
    // It comes from the left of where it goes first.
    for (const HandMove& move : moves_)
        if (move.act == HandMove::Act::glide) {
            place_ = move.to - Point(0.35, 0.3);
            break;
        }
}

double Hand::length() const {
    double all = 0;
    for (const HandMove& move : moves_) all += move.seconds;
    return all;
}

Pointer Hand::pointer(bool shift) const {
    Pointer pointer;
    pointer.position = place_;
    pointer.shift = shift;
    return pointer;
}

void Hand::perform(const std::string& name) {
    Document& document = bench_->document();
    if (name == "play") {
        bench_->cancel();
        document.play();
    } else if (name == "pause") {
        document.pause();
    } else if (name == "finish") {
        bench_->finish();
    } else if (name == "reset") {
        bench_->cancel();
        document.reset();
        bench_->documentChanged();
    } else if (act_) {
        act_(name);
    }
}

void Hand::begin(const HandMove& move) {
    from_ = place_;
    switch (move.act) {
        case HandMove::Act::press:
            pressed_ = true;
            shift_ = move.shift;
            bench_->press(pointer(shift_));
            break;
        case HandMove::Act::release:
            pressed_ = false;
            bench_->release(pointer(shift_));
            shift_ = false;
            break;
        case HandMove::Act::tool:
            bench_->setTool(move.chosen);
            break;
        case HandMove::Act::action:
            perform(move.name);
            break;
        case HandMove::Act::glide:
        case HandMove::Act::rest:
            break;
    }
}

void Hand::advance(double seconds) {
    while (!done()) {
        const HandMove& move = moves_[next_];
        if (!std::exchange(begun_, true)) begin(move);
        const double left = move.seconds - spent_;
        const bool ends = seconds >= left;
        spent_ = ends ? move.seconds : spent_ + seconds;
        seconds = ends ? seconds - left : 0;
        if (move.act == HandMove::Act::glide) {
            const double share = move.seconds > 0 ? spent_ / move.seconds : 1;
            const double eased = share * share * (3 - 2 * share);
            place_ = from_ + eased * (move.to - from_);
            bench_->move(pointer(shift_));
        }
        if (!ends) return;
        ++next_;
        spent_ = 0;
        begun_ = false;
    }
}

}  // namespace sulfurchamber
