// What the menus do with time.
#include <wx/menu.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "main_frame.hpp"

namespace sulfurchamber {
namespace {

constexpr std::array<int, 8> speedSteps{1, 10, 100, 250, 500, 1000, 2000, 4000};  // permille

}  // namespace

void MainFrame::changeSpeed(int steps) {
    const auto here = std::lower_bound(speedSteps.begin(), speedSteps.end(), view_.speedPermille());
    const auto place = static_cast<int>(here - speedSteps.begin()) + steps;
    const int last = static_cast<int>(speedSteps.size()) - 1;
    view_.setSpeedPermille(speedSteps.at(static_cast<std::size_t>(std::clamp(place, 0, last))));
}

void MainFrame::chooseSpeed(wxWindow& at) {
    wxMenu menu;
    for (const Action& action : actions_) {
        const bool speed = action.name.starts_with("speed-") || action.name == "slow";
        if (!speed) continue;
        menu.AppendCheckItem(action.id, action.label.BeforeFirst('\t'));
        menu.Check(action.id, action.checked());
    }
    at.PopupMenu(&menu);
}

void MainFrame::seekBy(double seconds) {
    const Document& document = bench_.document();
    const Timeline& timeline = document.timeline();
    const std::uint32_t line = timeline.line();
    const double tick = timeline.now() ? static_cast<double>(timeline.now()->tick) : 0;
    const double wanted =
        tick + std::round(seconds / static_cast<double>(document.world().tickDuration()));
    const auto clamped = std::clamp(wanted, static_cast<double>(timeline.first(line)),
                                    static_cast<double>(timeline.last(line)));
    view_.seek({line, static_cast<std::uint64_t>(clamped)});
}

void MainFrame::seekMark(bool forward) {
    const Timeline& timeline = bench_.document().timeline();
    const std::uint32_t line = timeline.line();
    const std::uint64_t now = timeline.now() ? timeline.now()->tick : 0;
    std::optional<std::uint64_t> found;
    for (const Mark& mark : timeline.marks(line)) {
        if (mark.tick < timeline.first(line)) continue;
        if (forward && mark.tick > now && !found) found = mark.tick;
        if (!forward && mark.tick < now) found = mark.tick;
    }
    if (found) view_.seek({line, *found});
}

void MainFrame::showOtherFuture() {
    const auto others = bench_.document().timeline().others();
    if (others.empty()) return;
    // In the order in which they began, and around.
    const std::uint32_t line = bench_.document().timeline().line();
    auto next = std::find_if(others.begin(), others.end(),
                             [&](const auto& other) { return other.branch > line; });
    if (next == others.end()) next = others.begin();
    view_.seek({next->branch, next->last});
}

}  // namespace sulfurchamber
