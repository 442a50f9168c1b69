#include "time_bar_layout.hpp"

#include <algorithm>
#include <cmath>

#include "../model/words.hpp"

namespace sulfurchamber {
namespace {

constexpr int mostTold = 3;

}  // namespace

TimeBarLayout::TimeBarLayout(const Timeline& timeline, double tickSeconds, double width)
    : line_(timeline.line()), width_(std::max(1.0, width)), tickSeconds_(tickSeconds) {
    if (line_ == 0) return;
    first_ = begin_ = timeline.first(line_);
    last_ = end_ = timeline.last(line_);
    const auto others = timeline.others();
    for (const auto& other : others) {
        begin_ = std::min(begin_, other.from);
        end_ = std::max(end_, other.last);
    }
    end_ = std::max(end_, begin_ + static_cast<std::uint64_t>(std::ceil(1 / tickSeconds)));
    if (timeline.now()) now_ = place(timeline.now()->tick);
    for (const auto& other : others) {
        Lane lane{other.branch, place(other.from), place(other.last), 0};
        const auto taken = [&](int row) {
            return std::any_of(lanes_.begin(), lanes_.end(), [&](const Lane& one) {
                return one.row == row && one.from <= lane.to && lane.from <= one.to;
            });
        };
        while (lane.row + 1 < mostRows && taken(lane.row)) ++lane.row;
        lanes_.push_back(lane);
    }
    for (Mark& mark : timeline.marks(line_)) spots_.push_back({place(mark.tick), std::move(mark)});
}

double TimeBarLayout::place(std::uint64_t tick) const {
    const double share = (static_cast<double>(tick) - static_cast<double>(begin_)) /
                         static_cast<double>(end_ - begin_);
    return std::clamp(share, 0.0, 1.0) * width_;
}

std::uint64_t TimeBarLayout::tickAt(double x) const {
    const double share = std::clamp(x / width_, 0.0, 1.0);
    return begin_ +
           static_cast<std::uint64_t>(std::llround(share * static_cast<double>(end_ - begin_)));
}

Moment TimeBarLayout::momentAt(double x) const {
    return {line_, std::clamp(tickAt(x), first_, last_)};
}

std::optional<Moment> TimeBarLayout::otherAt(double x, int row, double reach) const {
    for (const Lane& lane : lanes_) {
        if (lane.row != row || x < lane.from - reach || x > lane.to + reach) continue;
        return Moment{lane.branch, tickAt(std::clamp(x, lane.from, lane.to))};
    }
    return std::nullopt;
}

std::string TimeBarLayout::textAt(double x, double reach) const {
    std::string text = fixed(static_cast<double>(tickAt(x)) * tickSeconds_, 2) + " s";
    int told = 0;
    for (const Spot& spot : spots_)
        if (std::abs(spot.x - x) <= reach && ++told <= mostTold) text += ", " + textOf(spot.mark);
    return text;
}

}  // namespace sulfurchamber
