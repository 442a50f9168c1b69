#include "practice.hpp"

#include <algorithm>
#include <cmath>

#include "ideas.hpp"
#include "workers.hpp"

namespace quaoar {
namespace {

constexpr int quickTries = 3;
constexpr std::size_t quickChoices = 4;
/// What promises so much is not looked at further.
constexpr double good = 0.8;
constexpr int moreTries = 5;
constexpr std::size_t bestChoices = 2;
/// A place that promises less than this wants a way on to be searched for.
constexpr double hopeless = 0.25;
/// Simulated seconds for such a search.
constexpr double searchBudget = 120;

/// Plays on from where the session is: each place with the one choice and what it led to.
std::vector<Place> placesAlong(Session& session, const Way& way) {
    std::vector<Place> places;
    Player player(session);
    for (const Intention& step : way.steps) {
        Place place;
        place.here = situationOf(session);
        place.snapshot = session.snapshot();
        const Try attempt = tried(session, player, step);
        place.choices.push_back({step, {attempt}, 0});
        places.push_back(std::move(place));
        if (attempt.ending != Ending::done) break;
    }
    return places;
}

/// Adds them to the policy; `first` is the index of the first where that is known already.
void addPlaces(Policy& policy, std::vector<Place> places, int first = -1) {
    for (Place& place : places) {
        const PolicyChoice choice = place.choices.front();
        place.choices.clear();
        const int index = first >= 0 ? first : policy.add(std::move(place));
        first = -1;
        policy.addTry(index, policy.addChoice(index, choice.intention), choice.tries.front());
    }
}

}  // namespace

void learnWay(Policy& policy, Session& session, const Way& way) {
    session.restart();
    addPlaces(policy, placesAlong(session, way));
    policy.weigh();
}

Try Practice::attempt(Lesson& lesson, Session& session, const Intention& idea,
                      const Slip& slip) const {
    session.restore(*lesson.snapshot);
    Player player(session);
    const Try attempt = tried(session, player, idea, slip);
    lesson.simulated += attempt.seconds;
    return policy_.known(attempt);
}

double Practice::promise(const PolicyChoice& choice) const {
    double sum = 0;
    for (const Try& attempt : choice.tries) sum += policy_.worth(attempt);
    return choice.tries.empty() ? 0 : sum / static_cast<double>(choice.tries.size());
}

std::vector<Intention> Practice::ideasFor(const Lesson& lesson, Session& session,
                                          std::mt19937_64& random) const {
    std::vector<std::pair<double, const Intention*>> near;
    for (const Place& place : policy_.places()) {
        if (place.best < 0) continue;
        near.emplace_back(unlikeness(place.here, lesson.here),
                          &place.choices[static_cast<std::size_t>(place.best)].intention);
    }
    const std::size_t count = std::min<std::size_t>(3, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Intention> ideas;
    for (std::size_t i = 0; i < count; ++i) ideas.push_back(*near[i].second);
    for (std::size_t i = 0; i < std::min<std::size_t>(2, count); ++i) {
        ideas.push_back(varied(*near[i].second, random));
    }
    if (count > 0) ideas.push_back(steadily(*near[0].second));
    session.restore(*lesson.snapshot);
    for (int n = 0; n < 3; ++n) ideas.push_back(randomIdea(session, ground_.field, random));
    ideas.back() = steadily(ideas.back());
    return ideas;
}

/// Carries an idea out without slips, and lets it end by what can be seen.
PolicyChoice Practice::plainly(Lesson& lesson, Session& session, const Intention& idea) const {
    session.restore(*lesson.snapshot);
    Player player(session);
    PolicyChoice choice{idea, {}, 0};
    const Try attempt = tried(session, player, idea);
    if (attempt.ending == Ending::done) choice.intention = endedBySight(idea, player.trace());
    lesson.simulated += attempt.seconds;
    choice.tries.push_back(policy_.known(attempt));
    return choice;
}

void Practice::study(Lesson& lesson, Session& session, std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    Nerves nerves(options_.skill, seed ^ 0x5bd1e995u);
    if (lesson.place >= 0 && provesGood(lesson, session, nerves)) return;
    for (const Intention& idea : ideasFor(lesson, session, random)) {
        PolicyChoice choice = plainly(lesson, session, idea);
        if (promise(choice) > 0.05) lesson.choices.push_back(std::move(choice));
    }
    keepBest(lesson, quickChoices);
    tryAll(lesson, session, nerves, quickTries);
    keepBest(lesson, bestChoices);
    tryAll(lesson, session, nerves, moreTries);
    keepBest(lesson, bestChoices);
    const double best = lesson.choices.empty() ? 0 : promise(lesson.choices.front());
    if (best < hopeless) searchOn(lesson, session, seed);
}

/// Whether the choice that is known is good enough, which only few tries tell at first.
bool Practice::provesGood(Lesson& lesson, Session& session, Nerves& nerves) const {
    const Place& place = policy_.places()[static_cast<std::size_t>(lesson.place)];
    if (place.studies > 0 || place.best < 0) return false;
    const PolicyChoice& best = place.choices[static_cast<std::size_t>(place.best)];
    lesson.choices.push_back({best.intention, {}, 0});
    tryAll(lesson, session, nerves, quickTries + 1);
    return promise(lesson.choices.front()) > good;
}

void Practice::keepBest(Lesson& lesson, std::size_t count) const {
    std::stable_sort(
        lesson.choices.begin(), lesson.choices.end(),
        [&](const PolicyChoice& a, const PolicyChoice& b) { return promise(a) > promise(b); });
    if (lesson.choices.size() > count) lesson.choices.resize(count);
}

void Practice::tryAll(Lesson& lesson, Session& session, Nerves& nerves, int count) const {
    for (PolicyChoice& choice : lesson.choices) {
        for (int n = 0; n < count; ++n) {
            choice.tries.push_back(attempt(lesson, session, choice.intention, nerves.next()));
        }
    }
}

/// Looks for a way from here to where one knows how to go on.
void Practice::searchOn(Lesson& lesson, Session& session, std::uint64_t seed) const {
    SearchOptions options;
    options.seed = seed;
    options.start = lesson.snapshot;
    options.goal = [this](const Situation& situation) {
        for (const Place& place : policy_.places()) {
            if (place.value > 2 * hopeless && unlikeness(place.here, situation) < 0.7) return true;
        }
        return false;
    };
    Search search(session, ground_.field, options);
    const auto way = search.run(searchBudget);
    lesson.simulated += search.report().simulated;
    if (!way) return;
    session.restore(*lesson.snapshot);
    lesson.wayOn = placesAlong(session, *way);
}

/// Takes what was learned into the policy, in the order of the lessons.
void Practice::learn(std::vector<Lesson>& lessons) {
    const std::uint64_t base = (options_.seed * 1000 + ++round_) * 100000;
    forAll(ground_.level, options_.jobs, static_cast<int>(lessons.size()),
           [&](int i, Session& session) {
               study(lessons[static_cast<std::size_t>(i)], session,
                     base + static_cast<std::uint64_t>(i));
           });
    for (Lesson& lesson : lessons) {
        simulated_ += lesson.simulated;
        const int index =
            lesson.place >= 0 ? lesson.place : policy_.add({lesson.here, lesson.snapshot, {}});
        ++policy_.place(index).studies;
        for (const PolicyChoice& choice : lesson.choices) {
            const int at = policy_.addChoice(index, choice.intention);
            for (const Try& attempt : choice.tries) policy_.addTry(index, at, attempt);
        }
        addPlaces(policy_, std::move(lesson.wayOn), index);
    }
    policy_.weigh();
}

void Practice::studyAll() {
    std::vector<Lesson> lessons;
    for (std::size_t i = 0; i < policy_.places().size(); ++i) {
        const Place& place = policy_.places()[i];
        if (!place.snapshot || place.studies > 0) continue;
        lessons.push_back({static_cast<int>(i), place.here, place.snapshot, {}, {}, 0});
    }
    learn(lessons);
}

void Practice::wish(std::vector<Lesson>& lessons, const Decision& decision, bool wentWrong) const {
    const bool strange = decision.match.unlike > 1;
    if (!strange && !wentWrong) return;
    for (const Lesson& lesson : lessons) {
        if (unlikeness(lesson.here, decision.before) < 0.8) return;
    }
    Lesson lesson{-1, decision.before, decision.snapshot, {}, {}, 0};
    const Place& place = policy_.places()[static_cast<std::size_t>(decision.match.place)];
    if (decision.match.unlike < 0.4 && place.snapshot) {
        lesson.place = decision.match.place;
        lesson.here = place.here;
        lesson.snapshot = place.snapshot;
    }
    lessons.push_back(std::move(lesson));
}

/// What preceded deaths first, then what was not foreseen.
std::vector<Practice::Lesson> Practice::lessonsOf(const std::vector<PlayedGame>& games) const {
    std::vector<Lesson> lessons;
    for (const bool deaths : {true, false}) {
        for (const PlayedGame& game : games) {
            const auto& decisions = game.decisions;
            for (std::size_t i = 0; i < decisions.size(); ++i) {
                bool wrong = false;
                for (std::size_t k = i; k < std::min(i + lookBack, decisions.size()); ++k) {
                    wrong = wrong || decisions[k].attempt.ending == Ending::died;
                }
                if (deaths == wrong) wish(lessons, decisions[i], wrong);
                if (lessons.size() >= static_cast<std::size_t>(options_.studies)) return lessons;
            }
        }
    }
    return lessons;
}

Survival Practice::round() {
    std::vector<PlayedGame> games(static_cast<std::size_t>(options_.games));
    forAll(ground_.level, options_.jobs, options_.games, [&](int i, Session& session) {
        BotOptions bot;
        bot.skill = options_.skill;
        bot.remember = true;
        bot.seed = options_.seed * 7919 + 1000003 * (round_ + 1) + static_cast<std::uint64_t>(i);
        games[static_cast<std::size_t>(i)] = playGame(session, ground_, policy_, bot);
    });
    Survival survival;
    for (const PlayedGame& game : games) {
        ++survival.games;
        survival.finished += game.finished ? 1 : 0;
        simulated_ += game.seconds;
        for (const Decision& decision : game.decisions) {
            if (decision.match.unlike > 1) continue;
            policy_.addTry(decision.match.place, decision.choice, decision.attempt);
        }
    }
    std::vector<Lesson> lessons = lessonsOf(games);
    games.clear();
    learn(lessons);
    return survival;
}

}  // namespace quaoar
