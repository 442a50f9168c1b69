// What trees need in memory while they are solved. One is solved after the other, so that one piece
// of it does for all; the world keeps it, so that its steps allocate nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <sulfur/math.hpp>
#include <vector>

#include "core/elimination.hpp"

namespace sulfur::detail {

/// A link between two places, as the solver sees it at the moment.
struct Span {
    Point armHere{0, 0}, armThere{0, 0};  // m, from the nodes' centres
    Point apart{0, 0};                    // m, from the parent's place to this node's
};

/// A distance as the equation lambda + hk C + hb (C - C0) = 0 wants it. A rigid one has hk
/// infinite.
struct Elastic {
    bool rigid = true;
    double hk = 0;  // k h^2, kg
    double hb = 0;  // b h, kg
};

/// Of a chain of points (point_chain.cpp).
struct ChainScratch {
    /// Two numbers in one register, which every x86-64 has.
    using Pair [[gnu::vector_size(16)]] = double;

    /// A node in this tick.
    struct Node {
        Pair displacement{0, 0};  // m, of this step
        Pair velocity{0, 0};      // m/s
        Pair moved{0, 0};         // m, since the tick began
        Pair acceleration{0, 0};  // m/s^2
        Pair gravity{0, 0};       // m/s^2, of that
        Pair startVelocity{0, 0};
        double inverseMass = 0;  // 1/kg
    };

    /// A link that leads to the node of the same number from the one before it.
    struct Link {
        Pair apart{0, 0};    // m, when the tick began
        Pair now{0, 0};      // m, when the step began
        Pair start{0, 0};    // unit vector, when the step began
        Pair present{0, 0};  // gradient of the constraint
        double value = 0;    // C, m
        double lambda = 0, impulse = 0;
        double target = 0, scale = 0;  // m and 1/m: length to reach and its inverse
        double inverseLength = 0;      // when the step began
        double masses = 0;             // 1/kg, of both ends together
        double rest = 0, guess = 0;
        double share = 0;  // shareOf(rest)
    };

    /// An elastic link: the part that is no force, and the one that is.
    struct Spring {
        double stiffness = 0, damping = 0;
        double hk = 0, hb = 0, compliance = 0;
        double pull = 0, brake = 0;  // N/m, N s/m
        Pair held{0, 0};             // N, the force of the tick's start
        double early = 0;            // kg m, what the force has given in this step beyond that
        bool rigid = true;
    };

    /// Factors of the tridiagonal matrix, as they are found from both ends towards the middle.
    struct Factor {
        double inverse = 0;  // of the pivot
        double back = 0;     // what the eliminated neighbour, nearer to the end, adds
        double ahead = 0;    // what the neighbour nearer to the middle contributes, over the pivot
        double right = 0;    // right-hand side
    };

    std::vector<Node> nodes;
    std::vector<Link> links;
    std::vector<Spring> springs;
    std::vector<Factor> factors;

    void reserve(std::size_t count) {
        if (nodes.size() >= count) return;
        nodes.resize(count);
        links.resize(count);
        springs.resize(count);
        factors.resize(count);
    }
};

/// Of a tree that goes through the tick in steps of its own (step_trees.cpp).
struct StepScratch {
    struct Motion {
        Point place{0, 0};  // of the node's centre
        Point velocity{0, 0};
        double spin = 0;
        double angle = 0;          // since the tick began
        Point heading{1, 0};       // of that angle
        Point displacement{0, 0};  // of this step
        double turning = 0;
    };

    struct Node {
        Motion start;
        Point acceleration{0, 0}, gravity{0, 0};  // m/s^2; that of gravity is in the other too
        double angular = 0;
        double inverseMass = 0, inverseInertia = 0;
        double mostSpin = 0;  // rad/s
        double pull = 0;      // kg, sum of the tensions over lengths, times h^2
    };

    struct Link {
        Point armHere{0, 0}, armThere{0, 0};  // when the tick began
        Elastic elastic;                      // of one step
        double stiffness = 0, damping = 0;    // of the part that is no force
        double pull = 0, brake = 0;           // N/m and N s/m, of the one that is
        Point held{0, 0};                     // N, its force when the tick began
        double early = 0;                     // kg m, what it has given in this step beyond that
        double rest = 0;
        Point direction{0, 0};  // when the step began
        Span start;
        double length = 0;                    // when the step began
        std::array<double, 2> left{0, 0};     // of the error, what this step need not close
        std::array<double, 2> lambda{0, 0};   // of this step
        std::array<double, 2> impulse{0, 0};  // sum of lambda / step, kg m/s
        double guess = 0;                     // N, tension that was seen last
        bool inert = false;
    };

    std::vector<Node> nodes;
    std::vector<Motion> motion, before;
    std::vector<Link> links;
};

/// Of a network (step_networks.cpp). Vectors of three are places and angles of nodes.
struct NetworkScratch {
    using Freedoms = Eigen::Vector3d;

    struct Link {
        double rest = 0, size = 1;           // m, its length, and what its errors are relative to
        Elastic elastic;                     // of the part that is no force
        int rows = 0;                        // a distance 1, a meeting 2
        Span before, start, now;             // a step earlier, at its start, at its end
        double length = 0;                   // when the step began
        std::array<double, 2> left{0, 0};    // of the error, what this step need not close
        double mobility = 0;                 // 1/kg, of both ends together
        double least = 0;                    // compliance, 1/kg
        double turnHere = 0, turnThere = 0;  // 1/(kg m^2)
        double share = 0, shareHere = 0, shareThere = 0;  // of the averages of what follows
        Point direction{1, 0};
        Point meanHere{0, 0}, meanThere{0, 0};  // arms
        std::array<Freedoms, 2> here{Freedoms::Zero(), Freedoms::Zero()};
        std::array<Freedoms, 2> there{Freedoms::Zero(), Freedoms::Zero()};
        std::array<double, 2> value{0, 0};
        double compliance = 0;
        std::array<double, 2> lambda{0, 0};  // of this step
        std::array<double, 2> warm{0, 0}, best{0, 0};
    };

    std::vector<Link> links;
    std::vector<Freedoms> inverseMass, predicted, nodes;
    std::vector<double> sizes;  // m, of each node: its shortest link
    std::vector<Point> turned;  // of each node: unit vector of an angle
    std::vector<StepScratch::Motion> best;
    std::vector<std::array<double, 2>> values;  // of each link
    std::vector<Eigen::Vector2d> points;
    std::vector<Eigen::Vector3d> bodies;

    template <int N>
    auto& right() {
        if constexpr (N == 2)
            return points;
        else
            return bodies;
    }
};

struct TreeScratch {
    ChainScratch chain;
    StepScratch step;
    NetworkScratch network;
    Elimination<2> points;
    Elimination<3> bodies;
    std::vector<std::uint32_t> held;  // links of the tree that is swept, whose contacts press
    std::vector<Eigen::Vector3d> begins;  // of its nodes: m and rad, that rows begin with

    template <int N>
    Elimination<N>& elimination() {
        if constexpr (N == 2)
            return points;
        else
            return bodies;
    }
};

}  // namespace sulfur::detail
