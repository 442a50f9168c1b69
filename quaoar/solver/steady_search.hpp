// Looks for a way that a human can repeat: from one place of rest to the next.
//
// The archive of search.hpp with two differences. It holds only states in which the hero rests
// (stands, or hangs and swings no more), because there all that went a little wrong before is
// forgotten; and what leads to one is repeated with slips, and only kept if it mostly comes to the
// same.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "search.hpp"

namespace quaoar {

class SteadySearch : public Explorer {
public:
    /// Repeats with the slips of `skill`.
    SteadySearch(Session& session, const DistanceField& field, const Skill& skill,
                 std::uint64_t seed);

private:
    /// 0.4 m of position and of rope.
    struct Cell {
        std::int32_t x = 0, y = 0, length = 0;
        std::uint32_t signals = 0;
        friend auto operator<=>(const Cell&, const Cell&) = default;
    };
    struct Node {
        std::size_t parent = 0;
        std::vector<Intention> intentions;  ///< that led from the parent to here
        std::uint64_t ticks = 0;
        double reliability = 1;  ///< share of attempts that come here from the last checkpoint
    };
    struct State {
        std::size_t node = 0;
        std::shared_ptr<const Session::Snapshot> snapshot;
        Situation here;
        double distance = 0;
        int tries = 0;
    };

    static Cell cellOf(const Situation& situation);
    State& choose();
    Ending attempt(const Session::Snapshot& from, const std::vector<Intention>& intentions);
    double reliability(const State& from, const std::vector<Intention>& intentions,
                       const Situation& wanted, bool finished);
    void insert(std::size_t from, const std::vector<Intention>& intentions, std::uint64_t spent);
    Intention atRest(const Intention& idea);
    Way trace(std::size_t parent, const std::vector<Intention>& last, std::uint64_t ticks) const;
    std::optional<Way> explore() override;

    Nerves nerves_;
    std::vector<Node> nodes_;
    std::map<Cell, std::size_t> cells_;
    std::vector<State> states_;
};

}  // namespace quaoar
