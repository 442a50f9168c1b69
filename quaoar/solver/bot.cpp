#include "bot.hpp"

#include <algorithm>
#include <cmath>

#include "workers.hpp"

namespace quaoar {
namespace {

/// Nobody plays a level for longer than this.
constexpr double longestGame = 600;
/// Metres nearer to the exit that count as progress.
constexpr double progress = 0.3;
/// Beyond this a situation was not foreseen, and it takes the player's reaction to see it.
constexpr double foreseen = 2.5;

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// The state of one game while it is played.
class BotGame {
public:
    BotGame(Session& session, const Ground& ground, const Policy& policy, const BotOptions& options)
        : session_(session),
          ground_(ground),
          policy_(policy),
          options_(options),
          player_(session, options.recording),
          nerves_(options.skill, options.seed * 0x9e3779b97f4a7c15ull + 1) {
        session_.restart();
    }

    Game play() {
        while (seconds() < longestGame && lives_ <= options_.tries) {
            const Ending ending = decide();
            surprised_ = ending != Ending::done;
            if (ending == Ending::finished) {
                game_.finished = true;
                break;
            }
            if (ending == Ending::died) begin();
            if (player_.reachedCheckpoint()) lives_ = 1;
        }
        game_.seconds = seconds();
        return std::move(game_);
    }

private:
    double seconds() const { return static_cast<double>(player_.ticks()) / Session::tickRate; }

    void begin() {
        ++game_.tries;
        ++lives_;
        nearest_ = DistanceField::unreachable;
        lastProgress_ = seconds();
    }

    bool stalled() {
        const double distance = ground_.field.at(session_.heroPosition());
        if (distance < nearest_ - progress) {
            nearest_ = distance;
            lastProgress_ = seconds();
        }
        return seconds() - lastProgress_ > options_.patience;
    }

    Ending decide() {
        const Slip slip = nerves_.next();
        Situation now = situationOf(session_);
        Policy::Match match = policy_.match(now);
        if (surprised_ || match.unlike > foreseen) {
            const Ending ending = player_.wait(std::max(1, slip.reaction));
            if (ending != Ending::done) return ending;
            now = situationOf(session_);
            match = policy_.match(now);
        }
        if (match.place < 0) return Ending::died;
        const Place& place = policy_.places()[static_cast<std::size_t>(match.place)];
        Decision decision{now, nullptr, match, place.best, {}};
        if (options_.remember) decision.snapshot = session_.snapshot();
        const double began = seconds();
        const Choice& choice = place.choices[static_cast<std::size_t>(place.best)];
        Ending ending = player_.carryOut(choice.intention, slip);
        if (ending == Ending::done && stalled()) {
            session_.retry();
            ending = Ending::died;
        }
        decision.attempt = {ending, situationOf(session_), seconds() - began};
        game_.decisions.push_back(decision);
        return ending;
    }

    Session& session_;
    const Ground& ground_;
    const Policy& policy_;
    const BotOptions& options_;
    Player player_;
    Nerves nerves_;
    Game game_;
    double nearest_ = DistanceField::unreachable;
    double lastProgress_ = 0;
    bool surprised_ = false;
    int lives_ = 1;  ///< since the last checkpoint
};

}  // namespace

Game playGame(Session& session, const Ground& ground, const Policy& policy,
              const BotOptions& options) {
    return BotGame(session, ground, policy, options).play();
}

Survival measureSurvival(const Ground& ground, const Policy& policy, const BotOptions& options,
                         int count, int jobs, std::vector<bool>* used) {
    std::vector<Game> games(static_cast<std::size_t>(count));
    forAll(ground.level, jobs, count, [&](int i, Session& session) {
        BotOptions mine = options;
        mine.seed += static_cast<std::uint64_t>(i);
        games[static_cast<std::size_t>(i)] = playGame(session, ground, policy, mine);
    });
    Survival survival;
    survival.games = count;
    std::vector<double> tries, seconds;
    if (used != nullptr) used->assign(policy.places().size(), false);
    for (const Game& game : games) {
        survival.finished += game.finished ? 1 : 0;
        tries.push_back(game.tries);
        if (game.finished) seconds.push_back(game.seconds);
        if (used == nullptr) continue;
        for (const Decision& decision : game.decisions) {
            (*used)[static_cast<std::size_t>(decision.match.place)] = true;
        }
    }
    survival.tries = median(tries);
    survival.seconds = median(seconds);
    return survival;
}

}  // namespace quaoar
