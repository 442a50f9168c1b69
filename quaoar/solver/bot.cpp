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

    PlayedGame play() {
        while (player_.seconds() < longestGame && lives_ <= options_.tries) {
            const Ending ending = decide();
            surprised_ = ending != Ending::done;
            if (ending == Ending::finished) {
                game_.finished = true;
                break;
            }
            const int reached = checkpointsReached(session_);
            if (reached > reached_) lives_ = 1;
            reached_ = std::max(reached_, reached);
            if (ending == Ending::died) begin();
            if (options_.remember) forget();
        }
        game_.seconds = player_.seconds();
        return std::move(game_);
    }

private:
    void begin() {
        ++lives_;
        if (lives_ <= options_.tries) ++game_.tries;
        nearest_ = DistanceField::unreachable;
        lastProgress_ = player_.seconds();
    }

    bool stalled() {
        const double distance = ground_.field.at(session_.heroPosition());
        if (distance < nearest_ - progress) {
            nearest_ = distance;
            lastProgress_ = player_.seconds();
        }
        return player_.seconds() - lastProgress_ > options_.patience;
    }

    /// Drops the snapshot of a decision that nobody will look at again.
    void forget() {
        if (game_.decisions.size() < lookBack) return;
        const auto window = game_.decisions.end() - static_cast<std::ptrdiff_t>(lookBack);
        const bool led = std::any_of(window, game_.decisions.end(), [](const Decision& decision) {
            return decision.attempt.ending == Ending::died;
        });
        if (window->match.unlike <= 1 && !led) window->snapshot = nullptr;
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
        const PolicyChoice& choice = place.choices[static_cast<std::size_t>(place.best)];
        Try& attempt = decision.attempt;
        attempt = tried(session_, player_, choice.intention, slip);
        if (attempt.ending == Ending::done && stalled()) {
            attempt.ending = player_.giveUp();
            attempt.after = situationOf(session_);
        }
        game_.decisions.push_back(decision);
        return attempt.ending;
    }

    Session& session_;
    const Ground& ground_;
    const Policy& policy_;
    const BotOptions& options_;
    Player player_;
    Nerves nerves_;
    PlayedGame game_;
    double nearest_ = DistanceField::unreachable;
    double lastProgress_ = 0;
    bool surprised_ = false;
    int lives_ = 1;    ///< since the last checkpoint
    int reached_ = 0;  ///< most checkpoints reached
};

}  // namespace

PlayedGame playGame(Session& session, const Ground& ground, const Policy& policy,
                    const BotOptions& options) {
    return BotGame(session, ground, policy, options).play();
}

Survival measureSurvival(const Ground& ground, const Policy& policy, const BotOptions& options,
                         int count, int jobs, std::vector<bool>* used) {
    std::vector<PlayedGame> games(static_cast<std::size_t>(count));
    forAll(ground.level, jobs, count, [&](int i, Session& session) {
        BotOptions mine = options;
        mine.seed += static_cast<std::uint64_t>(i);
        games[static_cast<std::size_t>(i)] = playGame(session, ground, policy, mine);
    });
    Survival survival;
    survival.games = count;
    std::vector<double> tries, seconds;
    if (used != nullptr) used->assign(policy.places().size(), false);
    for (const PlayedGame& game : games) {
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
