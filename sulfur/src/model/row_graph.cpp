#include "model/row_graph.hpp"

#include <bit>
#include <cstring>

namespace sulfur::detail {

namespace {

bool isPushed(const Movers& movers, std::uint32_t m) {
    const SolverBody& body = movers.bodies[m];
    return body.inverseMass > 0 || body.inverseInertia > 0;
}

/// The first colour that none of the bodies has; they have it from now on.
template <std::size_t count>
std::uint32_t takeColour(Movers& movers, const std::array<std::uint32_t, count>& bodies) {
    std::uint64_t used = 0;
    for (const auto m : bodies)
        if (isPushed(movers, m)) used |= movers.colours[m];
    const auto colour = std::min<std::uint32_t>(static_cast<std::uint32_t>(std::countr_one(used)),
                                                RowGraph::overflow);
    if (colour == RowGraph::overflow) return colour;
    for (const auto m : bodies)
        if (isPushed(movers, m)) movers.colours[m] |= std::uint64_t{1} << colour;
    return colour;
}

template <std::size_t count>
void giveColourBack(Movers& movers, const std::array<std::uint32_t, count>& bodies,
                    std::uint32_t colour) {
    if (colour == RowGraph::overflow) return;
    for (const auto m : bodies)
        if (isPushed(movers, m)) movers.colours[m] &= ~(std::uint64_t{1} << colour);
}

// Blocks and shapes are made of lanes only, each of them eight numbers of one size.
static_assert(sizeof(ManifoldBlock) % sizeof(Lane) == 0 && sizeof(TouchBlock) % sizeof(Lane) == 0);

/// Copies one lane of everything from `from` to `to`. Numbers of 4 bytes come first (`places` of
/// them), then Reals.
template <class T>
void copyLane(const T& from, std::uint32_t f, T& to, std::uint32_t t, std::size_t places) {
    const auto* source = reinterpret_cast<const unsigned char*>(&from);
    auto* target = reinterpret_cast<unsigned char*>(&to);
    constexpr std::size_t word = sizeof(std::uint32_t), row = rowLanes * word;
    for (std::size_t k = 0; k < places; ++k)
        std::memcpy(target + k * row + t * word, source + k * row + f * word, word);
    const std::size_t start = places * row;
    for (std::size_t at = start; at + rowLanes * sizeof(Real) <= sizeof(T);
         at += rowLanes * sizeof(Real))
        std::memcpy(target + at + t * sizeof(Real), source + at + f * sizeof(Real), sizeof(Real));
}

constexpr std::size_t manifoldPlaces = 2, touchPlaces = 4, shapePlaces = 2;

template <class List>
void clearLane(List& list, std::size_t block, std::uint32_t lane, std::size_t blockPlaces) {
    static constexpr typename std::remove_reference_t<decltype(list.blocks)>::value_type noBlock{};
    static constexpr typename std::remove_reference_t<decltype(list.shapes)>::value_type noShape{};
    copyLane(noBlock, 0, list.blocks[block], lane, blockPlaces);
    copyLane(noShape, 0, list.shapes[block], lane, shapePlaces);
}

template <class List>
RowPlace append(List& list, std::uint32_t colour, std::size_t blockPlaces) {
    const RowPlace place{colour, list.rows++};
    const auto block = RowGraph::blockOf(place);
    if (block == list.blocks.size()) {
        list.blocks.push_back({});
        list.shapes.push_back({});
        list.pressing.push_back(0);
        if (block / 64 >= list.dirty.size()) list.dirty.push_back(0);
    }
    // Refreshes of the others in its block have given an empty lane directions; the impulses that a
    // row begins with have acted along none.
    clearLane(list, block, RowGraph::laneOf(place), blockPlaces);
    list.dirty[block / 64] |= std::uint64_t{1} << block % 64;
    return place;
}

/// The last row takes the place of one that goes.
template <class List>
void closeGap(List& list, RowPlace place, std::size_t blockPlaces) {
    const RowPlace last{place.colour, --list.rows};
    const auto from = RowGraph::blockOf(last), to = RowGraph::blockOf(place);
    const auto f = RowGraph::laneOf(last), t = RowGraph::laneOf(place);
    if (last.index != place.index) {
        copyLane(list.blocks[from], f, list.blocks[to], t, blockPlaces);
        copyLane(list.shapes[from], f, list.shapes[to], t, shapePlaces);
        const auto bit = (list.pressing[from] >> f & 1u) << t;
        list.pressing[to] = static_cast<std::uint8_t>((list.pressing[to] & ~(1u << t)) | bit);
        if (list.dirty[from / 64] >> from % 64 & 1)
            list.dirty[to / 64] |= std::uint64_t{1} << to % 64;
    }
    clearLane(list, from, f, blockPlaces);
    list.pressing[from] = static_cast<std::uint8_t>(list.pressing[from] & ~(1u << f));
    if (f != 0) return;
    list.blocks.pop_back();
    list.shapes.pop_back();
    list.pressing.pop_back();
    list.dirty[from / 64] &= ~(std::uint64_t{1} << from % 64);
}

}  // namespace

RowPlace RowGraph::addManifold(Movers& movers, std::uint32_t pair, std::uint32_t a,
                               std::uint32_t b) {
    const auto colour = takeColour<2>(movers, {a, b});
    ManifoldList& list = manifolds[colour];
    const RowPlace place = append(list, colour, manifoldPlaces);
    noteUse(colour);
    const auto lane = laneOf(place);
    list.blocks.back().a[lane] = a;
    list.blocks.back().b[lane] = b;
    list.shapes.back().pair[lane] = pair;
    return place;
}

RowPlace RowGraph::addTouch(Movers& movers, std::uint32_t touch, std::uint32_t p, std::uint32_t a,
                            std::uint32_t b) {
    const auto colour = takeColour<3>(movers, {p, a, b});
    TouchList& list = touches[colour];
    const RowPlace place = append(list, colour, touchPlaces);
    noteUse(colour);
    const auto lane = laneOf(place);
    list.blocks.back().p[lane] = p;
    list.blocks.back().a[lane] = a;
    list.blocks.back().b[lane] = b;
    list.shapes.back().touch[lane] = touch;
    return place;
}

std::uint32_t RowGraph::removeManifold(Movers& movers, RowPlace place) {
    ManifoldList& list = manifolds[place.colour];
    ManifoldBlock& block = manifold(place);
    const auto lane = laneOf(place);
    for (int k = 0; k < 2; ++k)
        pressManifold(movers, block, lane, k, -block.points[k].pressing[lane]);
    rubManifold(movers, block, lane, -block.rubbing[lane]);
    giveColourBack<2>(movers, {block.a[lane], block.b[lane]}, place.colour);
    const auto moved = list.rows - 1;
    closeGap(list, place, manifoldPlaces);
    noteUse(place.colour);
    return moved == place.index ? none : manifoldShape(place).pair[lane];
}

std::uint32_t RowGraph::removeTouch(Movers& movers, RowPlace place) {
    TouchList& list = touches[place.colour];
    TouchBlock& block = touch(place);
    const auto lane = laneOf(place);
    pressTouch(movers, block, lane, -block.pressing[lane], -block.rubbing[lane]);
    giveColourBack<3>(movers, {block.p[lane], block.a[lane], block.b[lane]}, place.colour);
    const auto moved = list.rows - 1;
    closeGap(list, place, touchPlaces);
    noteUse(place.colour);
    return moved == place.index ? none : touchShape(place).touch[lane];
}

namespace {

/// Pushes two bodies apart along (x, y).
void pushApart(Movers& movers, const ManifoldBlock& block, std::uint32_t l, Real x, Real y,
               Real armA, Real armB) {
    SolverBody &a = movers.bodies[block.a[l]], &b = movers.bodies[block.b[l]];
    a.vx -= x * a.inverseMass;
    a.vy -= y * a.inverseMass;
    a.spin -= armA * a.inverseInertia;
    b.vx += x * b.inverseMass;
    b.vy += y * b.inverseMass;
    b.spin += armB * b.inverseInertia;
}

}  // namespace

void RowGraph::pressManifold(Movers& movers, ManifoldBlock& block, std::uint32_t l, int point,
                             Real normal) {
    if (normal == 0) return;
    ManifoldPoint& p = block.points[point];
    pushApart(movers, block, l, p.normalX[l] * normal, p.normalY[l] * normal,
              p.normalArmA[l] * normal, p.normalArmB[l] * normal);
    p.pressing[l] += normal;
}

void RowGraph::rubManifold(Movers& movers, ManifoldBlock& block, std::uint32_t l, Real tangent) {
    if (tangent == 0) return;
    pushApart(movers, block, l, block.tangentX[l] * tangent, block.tangentY[l] * tangent,
              block.tangentArmA[l] * tangent, block.tangentArmB[l] * tangent);
    block.rubbing[l] += tangent;
}

void RowGraph::pressTouch(Movers& movers, TouchBlock& t, std::uint32_t l, Real normal,
                          Real tangent) {
    if (normal == 0 && tangent == 0) return;
    const Real nx = t.normalX[l], ny = t.normalY[l], rod = t.rod[l] * tangent + t.lean[l] * normal;
    const Real px = nx * normal - ny * tangent, py = ny * normal + nx * tangent;
    const Real rx = rod * t.sideX[l], ry = rod * t.sideY[l];
    SolverBody &p = movers.bodies[t.p[l]], &a = movers.bodies[t.a[l]], &b = movers.bodies[t.b[l]];
    p.vx += px * p.inverseMass;
    p.vy += py * p.inverseMass;
    p.spin += (t.normalArmP[l] * normal + t.tangentArmP[l] * tangent) * p.inverseInertia;
    a.vx -= (t.weightA[l] * px - rx) * a.inverseMass;
    a.vy -= (t.weightA[l] * py - ry) * a.inverseMass;
    a.spin -= (t.normalArmA[l] * normal + t.tangentArmA[l] * tangent) * a.inverseInertia;
    b.vx -= (t.weightB[l] * px + rx) * b.inverseMass;
    b.vy -= (t.weightB[l] * py + ry) * b.inverseMass;
    b.spin -= (t.normalArmB[l] * normal + t.tangentArmB[l] * tangent) * b.inverseInertia;
    t.pressing[l] += normal;
    t.rubbing[l] += tangent;
}

}  // namespace sulfur::detail
