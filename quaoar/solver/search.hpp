// Looks for a way through a level.
//
// An archive of states that were reached, one for each cell of position, velocity and rope; again
// and again one that is near the exit and rarely tried is restored and something that a player may
// mean to do is carried out from it (the scheme of "go-explore": Ecoffet, Huizinga, Lehman, Stanley
// and Clune, 2019, with the distance along free space as its guide).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <quaoar/session.hpp>
#include <random>
#include <vector>

#include "distance_field.hpp"
#include "intention.hpp"
#include "player.hpp"
#include "situation.hpp"

namespace quaoar {

struct Way {
    std::vector<Intention> steps;
    std::uint64_t ticks = 0;  ///< from the search's start to its goal
};

/// What is known about a search's world without simulating it, and shared by all that search it.
struct Ground {
    explicit Ground(std::shared_ptr<const Level> of);
    std::shared_ptr<const Level> level;
    DistanceField field;
};

struct SearchOptions {
    std::uint64_t seed = 1;
    /// Where the search starts; at the spawn if not given.
    std::shared_ptr<const Session::Snapshot> start;
    /// Whether a state is as good as the exit, besides the exit.
    std::function<bool(const Situation&)> goal;
};

struct SearchReport {
    double simulated = 0;   ///< seconds
    std::size_t cells = 0;  ///< different states in the archive
    double nearest = 0;     ///< metres left to the exit along free space, at best
};

/// A search in a session of its own, whose state it changes.
class Explorer {
public:
    virtual ~Explorer() = default;
    Explorer(const Explorer&) = delete;
    Explorer& operator=(const Explorer&) = delete;

    /// Goes on until a way is found, or until so many seconds were simulated in all.
    std::optional<Way> run(double until);
    const SearchReport& report() const { return report_; }

protected:
    Explorer(Session& session, const DistanceField& field, std::uint64_t seed)
        : session_(session), field_(field), random_(seed) {}
    /// One attempt from one state of the archive.
    virtual std::optional<Way> explore() = 0;
    /// Whether the session has come to a checkpoint that nothing in the archive has. Whoever falls
    /// comes back to the last one, and from each the level can be finished: what was reached before
    /// is of no use any more.
    bool entersStage();
    void count(std::uint64_t ticks) { report_.simulated += secondsOf(ticks); }

    Session& session_;
    const DistanceField& field_;
    std::mt19937_64 random_;
    SearchReport report_;
    int stage_ = 0;  ///< checkpoints reached by what is in the archive
};

class Search : public Explorer {
public:
    Search(Session& session, const DistanceField& field, const SearchOptions& options);

    /// The middles of the cells of the archive, metres: for pictures of the search.
    std::vector<sulfur::Point> frontier() const;

private:
    static constexpr double cellSide = 0.5;  ///< metres
    /// 0.5 m of position, 3 m/s of velocity, tied or not.
    struct Cell {
        std::int32_t x = 0, y = 0, vx = 0, vy = 0;
        bool tied = false;
        std::uint32_t signals = 0;
        friend auto operator<=>(const Cell&, const Cell&) = default;
    };
    /// What was done after another node. Never changed once made, so that every way back to the
    /// start stays as it was played.
    struct Node {
        std::size_t parent = 0;
        Intention intention;  ///< that led from the parent to here
        std::uint64_t ticks = 0;
    };
    struct State {
        std::size_t node = 0;
        std::shared_ptr<const Session::Snapshot> snapshot;
        double distance = 0;
        int tries = 0;
    };

    static Cell cellOf(const Situation& situation);
    State& choose();
    void insert(std::size_t parent, const Intention& intention, std::uint64_t ticks);
    Way trace(std::size_t parent, const Intention& last, std::uint64_t ticks) const;
    std::optional<Way> explore() override;

    SearchOptions options_;
    std::vector<Node> nodes_;
    std::map<Cell, std::size_t> cells_;
    std::vector<State> states_;
};

}  // namespace quaoar
