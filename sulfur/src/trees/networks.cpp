#include "trees/networks.hpp"

#include <algorithm>
#include <utility>

#include "core/settings.hpp"

namespace sulfur::detail {

namespace {

template <int N>
class Assembly {
public:
    using Vector = typename BlockFactor<N>::Vector;
    using Block = typename BlockFactor<N>::Block;

    Assembly(State& state, const Tree& tree, std::span<const NetworkRow> rows,
             NetworkSystem& system)
        : state_(state),
          tree_(tree),
          rows_(rows),
          pattern_(state.trees.factors[tree.network].pattern),
          factor_(system.factor<N>()) {}

    void factorise() {
        factor_.begin(pattern_);
        for (std::uint32_t i = 0; i < tree_.last - tree_.first; ++i) addMass(i);
        for (std::size_t l = 0; l < rows_.size(); ++l)
            addLink(state_.trees.links[tree_.firstLink + l], rows_[l]);
        factor_.factorise(pattern_);
    }

    void answers(std::span<const PressedRow> pressed, std::span<double> answers) const {
        using Lanes = typename BlockFactor<N>::Lanes;
        std::pmr::vector<Lanes> x(pattern_.size(), &state_.arena);
        for (std::size_t first = 0; first < pressed.size(); first += BlockFactor<N>::lanes) {
            const auto side = pressed.subspan(
                first, std::min<std::size_t>(BlockFactor<N>::lanes, pressed.size() - first));
            std::fill(x.begin(), x.end(), Lanes::Zero());
            for (std::size_t lane = 0; lane < side.size(); ++lane)
                forEachNode(side[lane], [&](std::uint32_t column, const Vector& along) {
                    x[column].col(static_cast<int>(lane)) += along;
                });
            factor_.solve(pattern_, std::span(x));
            for (std::size_t i = 0; i < pressed.size(); ++i)
                for (std::size_t lane = 0; lane < side.size(); ++lane)
                    forEachNode(pressed[i], [&](std::uint32_t column, const Vector& along) {
                        answers[(first + lane) * pressed.size() + i] +=
                            along.dot(x[column].col(static_cast<int>(lane)));
                    });
        }
    }

    void correct(std::vector<Freedoms>& nodes, std::vector<std::array<double, 2>>& links) {
        auto& x = state_.trees.scratch.network.right<N>();
        x.resize(pattern_.size());
        for (std::uint32_t i = 0; i < nodes.size(); ++i) x[pattern_.columnOf(i)] = -part(nodes[i]);
        forEachRow(
            [&](const NetworkLink& link, const NetworkRow& row, std::size_t l, std::size_t r) {
                const double push = row.stiffness[r] * links[l][r];
                x[pattern_.columnOf(link.here)] -= push * part(row.here[r]);
                x[pattern_.columnOf(link.there)] -= push * part(row.there[r]);
            });
        factor_.solve(pattern_, std::span(x));
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            nodes[i].setZero();
            nodes[i].template head<N>() = x[pattern_.columnOf(i)];
        }
        forEachRow(
            [&](const NetworkLink& link, const NetworkRow& row, std::size_t l, std::size_t r) {
                const double change =
                    row.here[r].dot(nodes[link.here]) + row.there[r].dot(nodes[link.there]);
                links[l][r] = -row.stiffness[r] * (links[l][r] + change);
            });
    }

private:
    static Vector part(const Freedoms& v) { return v.template head<N>(); }

    /// Calls f(column, direction) for the nodes that a row pushes.
    template <class Function>
    void forEachNode(const PressedRow& row, Function&& f) const {
        for (std::size_t k = 0; k < row.nodes.size(); ++k)
            if (row.nodes[k] != none) f(pattern_.columnOf(row.nodes[k]), part(row.along[k]));
    }

    /// Freedoms that a node has not get a one.
    void addMass(std::uint32_t i) {
        const Freedoms w = inverseMassOf(state_, state_.trees.nodes[tree_.first + i]);
        Block mass = Block::Zero();
        for (int k = 0; k < N; ++k) mass(k, k) = w[k] > 0 ? 1 / w[k] : 1;
        factor_.add(pattern_, i, mass);
    }

    void addLink(const NetworkLink& link, const NetworkRow& row) {
        for (std::size_t r = 0; r < 2; ++r)
            if (row.stiffness[r] != 0)
                addRow(link.here, link.there, row.stiffness[r], part(row.here[r]),
                       part(row.there[r]));
        if (row.tension != 0)
            addRow(link.here, link.there, row.tension, part(row.acrossHere), part(row.acrossThere));
        if constexpr (N == 3) {
            addTurn(link.here, row.turnHere);
            addTurn(link.there, row.turnThere);
        }
    }
    void addRow(std::uint32_t a, std::uint32_t b, double stiffness, const Vector& here,
                const Vector& there) {
        const Vector pull = stiffness * here;
        factor_.add(pattern_, a, pull * here.transpose());
        factor_.add(pattern_, b, (stiffness * there) * there.transpose());
        factor_.add(pattern_, a, b, pull * there.transpose());
    }
    void addTurn(std::uint32_t node, double stiffness) {
        Block block = Block::Zero();
        block(N - 1, N - 1) = stiffness;
        factor_.add(pattern_, node, block);
    }

    template <class Function>
    void forEachRow(Function&& f) const {
        for (std::size_t l = 0; l < rows_.size(); ++l)
            for (std::size_t r = 0; r < 2; ++r)
                if (rows_[l].stiffness[r] != 0)
                    f(state_.trees.links[tree_.firstLink + l], rows_[l], l, r);
    }

    State& state_;
    const Tree& tree_;
    std::span<const NetworkRow> rows_;
    const BlockPattern& pattern_;
    BlockFactor<N>& factor_;
};

}  // namespace

Freedoms inverseMassOf(const State& state, const TreeNode& node) {
    if (node.cluster != none) {
        const Cluster& c = state.clusters.list[node.cluster];
        const double w = static_cast<double>(c.inverseMass);
        return {w, w, static_cast<double>(c.inverseInertia)};
    }
    if (node.particle == none) return Freedoms::Zero();
    const double w = static_cast<double>(state.particles.inverseMass[node.particle]);
    return {w, w, 0};
}

bool analyseNetwork(State& state, const Tree& tree) {
    std::vector<BlockPattern::Edge> edges;
    for (auto l = tree.firstLink; l < tree.lastLink; ++l)
        edges.emplace_back(state.trees.links[l].here, state.trees.links[l].there);
    BlockPattern& pattern = state.trees.factors[tree.network].pattern;
    const std::uint32_t nodes = tree.last - tree.first;
    auto& earlier = state.trees.earlier;
    const auto known = std::find_if(earlier.begin(), earlier.end(), [&](const NetworkFactor& f) {
        return f.pattern.isOf(nodes, edges);
    });
    if (known == earlier.end())
        pattern.analyse(nodes, std::move(edges));
    else
        pattern = known->pattern;
    return pattern.products() <= tuned::mostProducts * pattern.size();
}

std::uint64_t priceOf(const State& state, const Tree& tree) {
    const BlockPattern& pattern = state.trees.factors[tree.network].pattern;
    return tuned::productsOfNode * pattern.size() + pattern.products();
}

std::uint64_t productsOfStep(const Tree& tree) {
    const std::uint64_t nodes = tree.last - tree.first;
    return tuned::networkProducts * nodes;
}

void prepareNetworks(State& state) {
    Trees& trees = state.trees;
    trees.factors.clear();
    for (const Tree& tree : trees.list) {
        if (tree.network == none) continue;
        trees.factors.emplace_back();
        analyseNetwork(state, tree);
    }
}

void factoriseNetwork(State& state, const Tree& tree, std::span<const NetworkRow> rows,
                      NetworkSystem& system) {
    if (tree.points)
        Assembly<2>(state, tree, rows, system).factorise();
    else
        Assembly<3>(state, tree, rows, system).factorise();
}

void correctNetwork(State& state, const Tree& tree, std::span<const NetworkRow> rows,
                    NetworkSystem& system, std::vector<Freedoms>& nodes,
                    std::vector<std::array<double, 2>>& values) {
    if (tree.points)
        Assembly<2>(state, tree, rows, system).correct(nodes, values);
    else
        Assembly<3>(state, tree, rows, system).correct(nodes, values);
}

void addAnswersOfNetwork(State& state, const Tree& tree, NetworkSystem& system,
                         std::span<const PressedRow> pressed, std::span<double> answers) {
    if (tree.points)
        Assembly<2>(state, tree, {}, system).answers(pressed, answers);
    else
        Assembly<3>(state, tree, {}, system).answers(pressed, answers);
}

bool isSlow(double worst, double last, double tolerance) {
    double expected = worst;
    for (int pass = 0; pass < tuned::factorPasses; ++pass) expected *= worst / last;
    return !(expected <= tolerance);
}

std::span<const NetworkRow> stepRows(State& state, const Tree& tree) {
    return std::span(state.trees.rows).subspan(tree.firstLink, tree.lastLink - tree.firstLink);
}

NetworkSystem& stepSystem(State& state, const Tree& tree) {
    NetworkSystem& system = state.trees.factors[tree.network].step;
    if (system.empty()) factoriseNetwork(state, tree, stepRows(state, tree), system);
    return system;
}

}  // namespace sulfur::detail
