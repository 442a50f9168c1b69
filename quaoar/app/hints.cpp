#include "hints.hpp"

#include <algorithm>

namespace quaoar {
namespace {

constexpr double near = 3.0;                      ///< metres from its place at which a hint appears
constexpr double far = 4.2;                       ///< and at which it goes
constexpr int readTicks = 5 * Session::tickRate;  ///< for a sentence that asks for nothing
constexpr int leastTicks = Session::tickRate;
constexpr int doneTicks = Session::tickRate / 10;  ///< so long an action is held until it is known
constexpr float fadePerTick = 4.0f / Session::tickRate;

double distance(const Hint& hint, sulfur::Point hero) {
    return (hint.position - hero).norm();
}

}  // namespace

void Hints::start(const Level& level) {
    hints_ = level.hints;
    progress_.assign(hints_.size(), {});
    for (std::size_t i = 0; i < hints_.size(); ++i)
        progress_[i].actions.assign(prompts_.named(hints_[i].text).size(), 0);
    current_ = hints_.size();
    visible_ = 0;
}

/// The one that is shown stays until it is done or far; then the nearest comes.
void Hints::choose(const Level& level, sulfur::Point hero) {
    if (level.hints.size() != hints_.size()) return;
    const bool stays = current_ < hints_.size() && !progress_[current_].done &&
                       distance(hints_[current_], hero) < far;
    if (stays || visible_ > 0) return;
    current_ = hints_.size();
    double best = near;
    for (std::size_t i = 0; i < hints_.size(); ++i) {
        if (progress_[i].done || distance(hints_[i], hero) >= best) continue;
        best = distance(hints_[i], hero);
        current_ = i;
    }
}

void Hints::learn(const Session& session, const atlax::ActionState& state) {
    Progress& progress = progress_[current_];
    ++progress.shown;
    const std::vector<atlax::Action> named = prompts_.named(hints_[current_].text);
    bool all = !named.empty();
    for (std::size_t i = 0; i < named.size(); ++i) {
        // A rope counts when it has stuck; what is pressed once counts at once.
        const bool rope = named[i] == actions_.fire;
        const bool once = rope || named[i] == actions_.restart || named[i] == actions_.pause;
        if (rope ? session.events().stuck : state.isDown(named[i]))
            progress.actions[i] += once ? doneTicks : 1;
        all = all && progress.actions[i] >= doneTicks;
    }
    const bool read = named.empty() && progress.shown >= readTicks;
    progress.done = read || (all && progress.shown >= leastTicks);
}

void Hints::tick(const Session& session, const atlax::ActionState& state) {
    const bool playing = session.phase() == Session::Phase::playing;
    const sulfur::Point hero = session.heroPosition();
    choose(session.level(), hero);
    const bool any = current_ < hints_.size();
    const bool wanted =
        any && playing && !progress_[current_].done && distance(hints_[current_], hero) < far;
    visible_ = std::clamp(visible_ + (wanted ? fadePerTick : -fadePerTick), 0.0f, 1.0f);
    if (wanted) learn(session, state);
}

std::string Hints::text() const {
    if (current_ >= hints_.size() || visible_ <= 0) return {};
    return prompts_.fill(texts_(hints_[current_].text));
}

void Hints::draw(const OverlayTools& tools) const {
    const std::string text = this->text();
    if (!text.empty()) drawBanner(tools, text, visible_);
}

}  // namespace quaoar
