// Direct solution of contacts along the paths on which load is carried.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/cholesky3.hpp"
#include "core/disjoint_sets.hpp"
#include "core/pieces.hpp"
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
    /// Whether there is, or may be, a tree in this tick that is not left to the sweeps.
    bool mayHelp() const { return mayHelp_; }

private:
    using Vector3 = Cholesky3::Vector;
    using Matrix3 = Cholesky3::Matrix;

    /// Where a node goes in this tick, so far.
    struct Motion {
        Vec2 displacement{0, 0};     // m
        Real sine = 0, versine = 0;  // of its turn; 1 - cos
    };
    /// A rigid component, or a disc that moves by itself (its third freedom is never used).
    struct Node {
        std::uint32_t cluster = none, particle = none;
        std::uint32_t parent = none;  // node
        std::uint32_t root = none;    // of its tree
        std::uint32_t carrying = 0;   // contacts that carry something, of which it is the first
        Motion moved;
        Matrix3 system;         // of the linear system, its lower half only
        Matrix3 towardsParent;  // its other part, then what elimination makes of it
        Vector3 motion;         // the right-hand side, then the solution
        // Of a root, for its tree.
        Real step = 1;  // share of the motion that the rows allow
        Real left = 1;  // share of its way that all steps so far have left
        bool unfinished = true;
        bool struck = false;                           // something runs into it
        std::uint32_t activeRows = 0, givingRows = 0;  // in its last step
        bool hopeless = false;                         // its rows allow next to nothing
    };
    /// All contacts between two nodes, or of one node with what does not move.
    struct Edge {
        std::uint32_t a = none, b = none;   // nodes; b is none for what does not move
        std::uint32_t first = 0, last = 0;  // part of keyed_
        Real carried = 0;                   // kg m
        bool chosen = false;
    };
    /// One side of a contact: a point of a node, or none of any.
    struct Hold {
        std::uint32_t node = none;
        Vec2 arm{0, 0};  // m
    };
    /// A contact in a row: what tells its error, and its share of the multiplier.
    struct Member {
        std::uint32_t contact = 0;
        Hold particle, capsule;
        Vec2 direction{0, 0};  // the normal or the tangent
        Real base = 0;         // m, the error but for what the nodes do
        Real shareA = 0;       // of the capsule's hold
        Real friction = 0;     // the static coefficient; 0 for what cannot stick
        Real pushesBelow = 0;  // m, of the error: a normal that carries nothing yet
        bool entire = true;    // the two holds are all that moves
        Real share = 0;        // of the row's multiplier, while it is active
    };
    /// A constraint error + a . u_a + b . u_b = 0, held by a penalty. The contacts of an edge that
    /// ask for the same have it together (both tangents of a face that lies on another, or two
    /// contacts of one corner): apart, the penalty would make of what rounding has them differ by
    /// as much as what they carry.
    struct Row {
        std::uint32_t edge = 0;
        std::uint32_t first = 0, last = 0;  // part of members_
        bool isNormal = false;
        Vector3 a, b;
        double weight = 0;  // kg
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
    /// Nodes that contacts join, by the first of them.
    struct Heap {
        std::uint32_t first = 0;     // of the heap to which the node with this number belongs
        std::uint32_t carrying = 0;  // contacts
        bool struck = false;
    };
    /// What rows of one tree add up to, for whoever joins what pieces found.
    struct Tally {
        std::uint32_t root = none;
        Real step = 1;  // the least that any row allows
        std::uint32_t activeRows = 0, givingRows = 0;
    };
    /// Work for a thread: the rows of some edges, and the nodes at which these begin. An edge may
    /// lead on to a node of a later piece.
    struct alignas(128) Piece {  // (Threads that write to one line of the caches wait for it.)
        std::uint32_t firstRow = 0, lastRow = 0, firstNode = 0, lastNode = 0;
        std::uint32_t firstActive = 0, lastActive = 0;  // part of active_, from firstRow on
        std::vector<std::uint32_t> leadingOn;           // of these
        std::vector<Tally> tallies;                     // of neighbours, in their order
    };
    /// What a contact carries, and what it has given up in this call.
    struct Carried {
        Real normal = 0, tangent = 0;  // kg m
        Real normalChange = 0;         // kg m, in this step
        bool given = false;            // its normal is no longer active
        bool slipping = false;         // nor its tangent
        bool inRow = false;            // while the rows of its edge are made: it is in one
    };

    void grow(const State& state);
    std::uint32_t nodeOf(const State& state, const Grip& grip);
    std::uint32_t addNode(const State& state, const Grip& grip);
    std::uint32_t knownNodeOf(const Grip& grip) const;
    void collectContacts(const State& state);
    static std::uint32_t firstOf(const Keyed& k);
    static std::uint32_t secondOf(const Keyed& k);
    bool findHeaps();
    void leaveStruckHeaps(const State& state);
    void collectEdges(const State& state);
    void chooseEdges();
    void orderNodes();
    void collectRows(const State& state);
    void collectRowsOf(const State& state, std::uint32_t edge, bool areNormals);
    Member makeMember(const State& state, std::uint32_t contact, bool isNormal) const;
    Row makeRow(const State& state, std::uint32_t edge, std::uint32_t contact, bool isNormal) const;
    bool isAlike(const Row& p, const Row& q) const;
    std::span<Member> membersOf(const Row& row) {
        return std::span(members_).subspan(row.first, row.last - row.first);
    }
    std::span<const Member> membersOf(const Row& row) const {
        return std::span(members_).subspan(row.first, row.last - row.first);
    }
    void takeMotions(const State& state);
    void takeMultipliers(const State& state);
    void giveMultipliers(State& state) const;
    Vec2 wayOf(const Hold& hold) const;
    Real errorOf(const State& state, const Member& m, bool isNormal) const;
    void divide(Tasks* tasks);
    /// Calls f(Piece&) for all, at once.
    template <class Function>
    void forEachPiece(Function&& f) {
        runPieces(tasks_, pieceCount_, [&](std::size_t i) { f(pieces_[i]); });
    }
    template <class Function>
    void forEachNode(Function&& f);
    template <class Function>
    void tallyActive(Piece& piece, Function&& add);
    template <class Function>
    void forEachTally(Function&& f);
    std::span<ActiveRow> activeOf(const Piece& piece) {
        return std::span(active_).subspan(piece.firstActive, piece.lastActive - piece.firstActive);
    }
    bool activateRows(const State& state);
    void activateNormal(const State& state, std::uint32_t row, Piece& piece);
    void activateTangent(const State& state, std::uint32_t row, Piece& piece);
    void activate(const State& state, std::uint32_t row, Real sum, Piece& piece);
    void assemble(const State& state);
    void addToFirst(const ActiveRow& active);
    void addToSecond(const ActiveRow& active);
    void eliminate();
    void substitute();
    void findChanges();
    Real allowedAlong(const ActiveRow& active) const;
    Real allowedAcross(const ActiveRow& active) const;
    std::uint32_t rootOf(const Row& row) const { return nodes_[edges_[row.edge].a].root; }
    const Node& treeOf(const Row& row) const { return nodes_[rootOf(row)]; }
    void findSteps();
    void moveNodes(State& state);
    static bool isHopeless(const Node& tree);
    void shareTangents(const Row& row);
    bool takeStepOf(const ActiveRow& active);
    void takeStep(State& state, bool mayEnd);
    bool leaveStruck(const State& state);

    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<Row> rows_;  // of the chosen edges, in their order: normals, then tangents
    std::vector<Member> members_;
    std::vector<ActiveRow> active_;  // of each piece, from the number of its first row on
    std::vector<Piece> pieces_;      // at least pieceCount_
    std::size_t pieceCount_ = 1;
    Tasks* tasks_ = nullptr;
    std::vector<Carried> carried_;  // by contact
    std::vector<Keyed> keyed_, keyedScratch_;
    std::vector<Heap> heaps_;  // by node
    std::vector<std::uint32_t> nodeOfCluster_, nodeOfParticle_;
    std::vector<std::uint32_t> byLoad_, byLoadScratch_;  // edges
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> start_, neighbour_;
    DisjointSets trees_;
    bool grown_ = false, mayHelp_ = true;

    /// m/s, of the largest error: a tree that something strikes. So many rows give way in it that
    /// one of so many active rows is left to the sweeps (nine tenths of such work had no effect),
    /// and a smaller one takes the least number of steps and lets go of all such rows at once.
    static constexpr Real struckSpeed = Real(0.1);
};

}  // namespace sulfur::detail
