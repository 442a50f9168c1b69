// Direct solution of contacts along the paths on which load is carried.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/cholesky3.hpp"
#include "core/disjoint_sets.hpp"
#include "world/state.hpp"

namespace sulfur::detail {

/// Sweeps carry the weight of a stack down by one body each, and an error between its bodies dies
/// out only after as many sweeps as the square of its height. So bodies that move as one (rigid
/// components, discs) are joined by the contacts that carry most into trees, and the multipliers
/// of a whole tree are found at once, with all others as they are: a step of block coordinate
/// descent. Bounds are put on afterwards (Silcowitz-Hansen, Niebe and Erleben 2010, "Projected
/// Gauss-Seidel subspace minimization"), and sweeps mend what that changes.
///
/// Holds scratch memory only.
class ContactForest {
public:
    /// A new tick: other contacts. Makes room for as many again, so that the first error does not
    /// allocate when it comes.
    void forget(const State& state);
    /// Changes multipliers and displacements so that the active constraints of each tree hold.
    void solve(State& state);

private:
    using Vector3 = Cholesky3::Vector;
    using Matrix3 = Cholesky3::Matrix;

    /// A rigid component, or a disc that moves by itself (its third freedom is never used).
    struct Node {
        std::uint32_t cluster = none, particle = none;
        std::uint32_t parent = none;    // node
        std::uint32_t root = none;      // of its tree
        Matrix3 system, towardsParent;  // of the linear system, then what elimination makes of it
        Vector3 motion;                 // the right-hand side, then the solution
        // Of a root, for its tree.
        Real step = 1;  // share of the motion that the rows allow
        bool unfinished = true;
    };
    /// All contacts between two nodes, or of one node with what does not move.
    struct Edge {
        std::uint32_t a = none, b = none;   // nodes; b is none for what does not move
        std::uint32_t first = 0, last = 0;  // part of keyed_
        Real carried = 0;                   // kg m
        bool chosen = false;
    };
    /// A constraint error + a . u_a + b . u_b = 0, held by a penalty. The contacts of an edge that
    /// ask for the same have it together (both tangents of a face that lies on another, or two
    /// contacts of one corner): apart, the penalty would make of what rounding has them differ by
    /// as much as what they carry.
    struct Row {
        std::uint32_t edge = 0;
        std::uint32_t firstMember = none;
        bool isNormal = false;
        Vector3 a, b;
        double weight = 0;  // kg
    };
    /// A contact in a row, and its share of the multiplier while the row is active.
    struct Member {
        std::uint32_t contact = 0;
        std::uint32_t next = none;  // member of the same row
        Real share = 0;
    };
    /// A row that holds in the present step.
    struct ActiveRow {
        std::uint32_t row = 0;
        double error = 0;  // m
        Real change = 0;   // kg m, of the multiplier
        Real allowed = 1;  // share of it that bounds leave
    };
    /// A contact and the nodes that it holds apart.
    struct Keyed {
        std::uint64_t nodes = 0;
        std::uint32_t contact = 0;

        friend bool operator<(const Keyed& p, const Keyed& q) {
            return p.nodes != q.nodes ? p.nodes < q.nodes : p.contact < q.contact;
        }
    };

    void grow(const State& state);
    std::uint32_t nodeOf(const State& state, const Grip& grip);
    void collectContacts(const State& state);
    void collectEdges(const State& state);
    void chooseEdges();
    void orderNodes();
    void collectRows(const State& state);
    Row makeRow(const State& state, std::uint32_t edge, std::uint32_t contact, bool isNormal) const;
    void addToRows(const Row& row, std::uint32_t firstOfEdge, std::uint32_t contact);
    template <class Function>
    void forEachMember(const Row& row, Function&& f);
    template <class Function>
    void forEachMember(const Row& row, Function&& f) const;
    void activateRows(const State& state);
    template <class IsActive, class Error>
    void activate(const State& state, std::uint32_t row, IsActive&& isActive, Error&& errorOf);
    bool pushes(const State& state, std::uint32_t contact) const;
    bool sticks(const State& state, std::uint32_t contact) const;
    void assemble(const State& state);
    void eliminate();
    void substitute();
    void findChanges();
    Real allowedAlong(const State& state, const ActiveRow& active) const;
    Real allowedAcross(const State& state, const ActiveRow& active) const;
    std::uint32_t treeOf(const ActiveRow& active) const {
        return nodes_[edges_[rows_[active.row].edge].a].root;
    }
    void findSteps(const State& state);
    void moveNodes(State& state) const;
    bool takeStep(State& state);

    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<Row> rows_;  // of the chosen edges, in their order
    std::vector<Member> members_;
    std::vector<ActiveRow> active_;
    std::vector<Real> normalChange_;  // kg m, per contact: of its normal in this step
    std::vector<Keyed> keyed_, keyedScratch_;
    std::vector<std::uint32_t> nodeOfCluster_, nodeOfParticle_;
    std::vector<std::pair<Real, std::uint32_t>> byLoad_;  // what an edge carries, negative; edge
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> start_, neighbour_;
    std::vector<std::uint8_t> given_, slipping_;  // per contact: no longer active
    DisjointSets trees_;
    bool grown_ = false;
};

}  // namespace sulfur::detail
