// Looks for a way through a level.
//
// An archive of states that were reached, one for each cell of position, velocity and rope; again
// and again one that is near the exit and rarely tried is restored and a random action of a
// player is carried out from it (the scheme of "go-explore": Ecoffet, Huizinga, Lehman, Stanley
// and Clune, 2019, with the distance along free space as its guide).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <quaoar/recording.hpp>
#include <quaoar/session.hpp>
#include <random>
#include <vector>

#include "distance_field.hpp"

namespace quaoar {

struct SearchOptions {
    std::uint64_t seed = 1;
    double budget = 20000;  ///< simulated seconds after which the search gives up
};

struct SearchReport {
    double simulated = 0;   ///< seconds
    std::size_t cells = 0;  ///< different states in the archive
    double nearest = 0;     ///< metres left to the exit along free space, at best
};

class Search {
public:
    Search(std::shared_ptr<const Level> level, const SearchOptions& options);

    /// The inputs that lead to the exit, or nothing when the budget was spent.
    std::optional<Recording> run();
    const SearchReport& report() const { return report_; }

private:
    /// 0.5 m of position, 3 m/s of velocity, tied or not.
    struct Cell {
        std::int32_t x = 0, y = 0, vx = 0, vy = 0;
        bool tied = false;
        friend auto operator<=>(const Cell&, const Cell&) = default;
    };
    /// What was done after another node. Never changed once made, so that every way back to the
    /// spawn stays as it was played.
    struct Node {
        std::size_t parent = 0;
        std::vector<InputRun> action;
        std::uint64_t ticks = 0;  ///< since the spawn
    };
    struct State {
        std::size_t node = 0;
        std::shared_ptr<const Session::Snapshot> snapshot;
        double distance = 0;
        int tries = 0;
    };

    Cell cellOf() const;
    State& choose();
    std::vector<InputRun> randomAction();
    /// Carries an action out; cuts it short when the exit is reached. Whether it was.
    bool carryOut(std::vector<InputRun>& action);
    void insert(std::size_t parent, std::vector<InputRun> action);
    Recording trace(std::size_t parent, const std::vector<InputRun>& last) const;
    double unit();
    int whole(int below);

    SearchOptions options_;
    std::shared_ptr<const Level> level_;
    Session session_;
    DistanceField field_;
    std::mt19937_64 random_;
    std::vector<Node> nodes_;
    std::map<Cell, std::size_t> cells_;
    std::vector<State> states_;
    SearchReport report_;
};

}  // namespace quaoar
