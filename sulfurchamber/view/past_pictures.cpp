#include "past_pictures.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace sulfurchamber {
namespace {

constexpr std::int64_t costShare = 20;        // of the time, one part is for drawing
constexpr std::uint64_t picturesOfLine = 40;  // evenly spaced; the rest is for other futures
constexpr double nearSeconds = 0.5;           // twice the time between two at full speed
constexpr double shortestBar = 1;             // seconds that the bar has at least

bool earlier(const Moment& a, const Moment& b) {
    return std::pair(a.branch, a.tick) < std::pair(b.branch, b.tick);
}

std::uint64_t distance(std::uint64_t a, std::uint64_t b) {
    return a < b ? b - a : a - b;
}

std::uint64_t barTicks(const Document& document) {
    const Timeline& timeline = document.timeline();
    const auto least = static_cast<std::uint64_t>(
        shortestBar / static_cast<double>(document.world().tickDuration()));
    return std::max(least, timeline.last(timeline.line()) - timeline.first(timeline.line()));
}

// At a distance of a few pictures none stands for a moment any more.
std::uint64_t nearTicks(const Document& document) {
    const auto least = static_cast<std::uint64_t>(
        nearSeconds / static_cast<double>(document.world().tickDuration()));
    return std::max(least, 3 * barTicks(document) / picturesOfLine);
}

const PastPictures::Picture* nearest(const std::vector<const PastPictures::Picture*>& pictures,
                                     std::uint64_t tick, std::uint64_t within) {
    const PastPictures::Picture* found = nullptr;
    for (const auto* one : pictures) {
        const std::uint64_t away = distance(one->moment.tick, tick);
        if (away > within || (found != nullptr && away >= distance(found->moment.tick, tick)))
            continue;
        found = one;
    }
    return found;
}

}  // namespace

bool PastPictures::due(const Document& document, std::int64_t nowNs) {
    const Timeline& timeline = document.timeline();
    std::erase_if(pictures_, [&](const Picture& one) { return !timeline.owns(one.moment); });
    const auto moment = document.recordedMoment();
    if (!moment) return false;
    const Moment own = timeline.own(*moment);
    std::erase_if(pictures_, [&](const Picture& one) {
        return one.moment == own && one.revision != document.revision();
    });
    if (nowNs < nextNs_) return false;
    const std::uint64_t apart = barTicks(document) / picturesOfLine;
    return nearest(ofLine(timeline), moment->tick, apart) == nullptr;
}

void PastPictures::add(const Document& document, atlax::Image image, std::int64_t nowNs,
                       std::int64_t costNs) {
    const Moment moment = document.timeline().own(*document.recordedMoment());
    const auto place =
        std::upper_bound(pictures_.begin(), pictures_.end(), moment,
                         [](const Moment& a, const Picture& b) { return earlier(a, b.moment); });
    pictures_.insert(place, {++lastSerial_, moment, document.revision(), std::move(image)});
    nextNs_ = nowNs + std::max(restNs, costShare * costNs);
    if (pictures_.size() > most) thin();
}

// The one goes without which the gap is smallest. The first of a branch has none before it.
void PastPictures::thin() {
    auto least = pictures_.begin();
    std::uint64_t gap = std::numeric_limits<std::uint64_t>::max();
    for (auto one = pictures_.begin(); one != pictures_.end(); ++one) {
        if (one == pictures_.begin() || std::prev(one)->moment.branch != one->moment.branch)
            continue;
        const auto after = std::next(one);
        const bool last = after == pictures_.end() || after->moment.branch != one->moment.branch;
        const std::uint64_t until = last ? one->moment.tick : after->moment.tick;
        const std::uint64_t left = until - std::prev(one)->moment.tick;
        if (left >= gap) continue;
        gap = left;
        least = one;
    }
    pictures_.erase(least);
}

std::vector<const PastPictures::Picture*> PastPictures::ofLine(const Timeline& timeline) const {
    std::vector<const Picture*> found;
    if (timeline.empty()) return found;
    const std::uint32_t line = timeline.line();
    for (const Picture& one : pictures_)
        if (timeline.own({line, one.moment.tick}) == one.moment) found.push_back(&one);
    return found;
}

const PastPictures::Picture* PastPictures::near(const Document& document,
                                                const Moment& moment) const {
    const auto pictures = ofLine(document.timeline());
    return pictures.empty() ? nullptr : nearest(pictures, moment.tick, nearTicks(document));
}

std::vector<const PastPictures::Picture*> PastPictures::strip(const Document& document,
                                                              const TimeBarLayout& layout,
                                                              double width, int places) const {
    std::vector<const Picture*> strip(static_cast<std::size_t>(std::max(0, places)), nullptr);
    const auto pictures = ofLine(document.timeline());
    if (layout.empty() || pictures.empty()) return strip;
    const double step = width / places;
    const std::uint64_t within =
        std::max(nearTicks(document), barTicks(document) / static_cast<std::uint64_t>(places));
    for (std::size_t i = 0; i < strip.size(); ++i) {
        const double middle = (static_cast<double>(i) + 0.5) * step;
        if (middle < layout.from() || middle - step / 2 > layout.to()) continue;
        strip[i] = nearest(pictures, layout.momentAt(middle).tick, within);
    }
    return strip;
}

}  // namespace sulfurchamber
