#include "solver/split.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bodies/pose.hpp"
#include "bodies/skins.hpp"
#include "core/disjoint_sets.hpp"
#include "core/trigonometry.hpp"
#include "solver/compact.hpp"

namespace sulfur::detail {

namespace {

/// Particles of a body that its joints connect, in groups; by the lowest particle of each.
using Groups = std::map<std::uint32_t, std::vector<std::uint32_t>>;

Groups groupsOf(const State& state, std::uint32_t index) {
    const BodyRecord& body = state.bodies[index];
    DisjointSets sets(body.particles.size());
    for (const JointId id : body.joints) {
        const auto j = state.jointSlots.dense(id);
        sets.unite(state.joints.a[j] - body.firstParticle, state.joints.b[j] - body.firstParticle);
    }
    Groups groups;
    for (std::uint32_t k = 0; k < body.particles.size(); ++k)
        groups[sets.find(k)].push_back(body.firstParticle + k);
    return groups;
}

double massOf(const State& state, const std::vector<std::uint32_t>& particles) {
    double sum = 0;
    for (const auto i : particles) sum += static_cast<double>(state.particles.mass[i]);
    return sum;
}

/// What has no surface left and hangs on nothing would fall through everything.
bool isLost(const State& state, const std::vector<std::uint32_t>& group) {
    const auto isOurs = [&](std::uint32_t i) {
        return std::binary_search(group.begin(), group.end(), i);
    };
    const Joints& joints = state.joints;
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        const bool a = isOurs(joints.a[j]), b = isOurs(joints.b[j]);
        if (a != b || (a && joints.radius[j] > 0)) return false;
    }
    return std::none_of(group.begin(), group.end(), [&](std::uint32_t i) {
        return state.particles.radius[i] > 0 || isAttached(state, i);
    });
}

/// The pieces that the broken joints have set free, in the order of their particles. Groups at
/// which nothing broke were apart before and stay.
struct Breakup {
    std::vector<std::vector<std::uint32_t>> pieces;
    std::vector<std::uint32_t> lost;
};

Breakup breakUp(const State& state, std::uint32_t body, const std::vector<std::uint32_t>& ends) {
    Groups groups = groupsOf(state, body);
    if (groups.size() < 2) return {};
    const auto heaviest =
        std::max_element(groups.begin(), groups.end(), [&](const auto& a, const auto& b) {
            return massOf(state, a.second) < massOf(state, b.second);
        });
    Breakup result;
    for (auto& [lowest, group] : groups) {
        const bool broke = std::any_of(group.begin(), group.end(), [&](std::uint32_t i) {
            return std::binary_search(ends.begin(), ends.end(), i);
        });
        if (!broke) continue;
        if (isLost(state, group))
            result.lost.insert(result.lost.end(), group.begin(), group.end());
        else if (lowest != heaviest->first)
            result.pieces.push_back(group);
    }
    return result;
}

void inheritVetoes(State& state, BodyId from, BodyId piece) {
    auto& vetoes = state.vetoes;
    for (std::size_t i = 0, count = vetoes.size(); i < count; ++i) {
        const BodyPair pair = vetoes[i];
        if (pair.a == from) vetoes.push_back(BodyPair::of(piece, pair.b));
        if (pair.b == from) vetoes.push_back(BodyPair::of(piece, pair.a));
    }
    std::sort(vetoes.begin(), vetoes.end());
}

/// Makes a piece a body at the end of the list. Its particles still stand among those of the body
/// that it broke from; see reorderParticles().
void makePiece(State& state, std::uint32_t from, const std::vector<std::uint32_t>& group) {
    const auto index = static_cast<std::uint32_t>(state.bodies.size());
    BodyRecord piece = state.bodies[from];
    piece.id = state.bodySlots.insert(index);
    piece.clustersStale = true;
    cutSkin(piece, [&](std::size_t k) {
        return std::binary_search(group.begin(), group.end(),
                                  piece.firstParticle + static_cast<std::uint32_t>(k));
    });
    piece.particles.clear();
    piece.joints.clear();
    for (const auto i : group) {
        piece.particles.push_back(state.particles.id[i]);
        state.particles.body[i] = index;
    }
    for (const JointId id : state.bodies[from].joints) {
        const auto j = state.jointSlots.dense(id);
        if (state.particles.body[state.joints.a[j]] != index) continue;
        piece.joints.push_back(id);
        state.joints.body[j] = index;
    }
    inheritVetoes(state, state.bodies[from].id, piece.id);
    state.bodies.push_back(std::move(piece));
    state.bodyIds.push_back(state.bodies.back().id);
    state.events.bodiesSplit.push_back({state.bodies[from].id, state.bodies.back().id});
}

/// Takes from a body what has become part of its pieces.
void shrink(State& state, std::uint32_t index) {
    BodyRecord& body = state.bodies[index];
    cutSkin(body,
            [&](std::size_t k) { return state.particles.body[body.firstParticle + k] == index; });
    std::erase_if(body.particles, [&](ParticleId id) {
        return state.particles.body[state.particleSlots.dense(id)] != index;
    });
    std::erase_if(body.joints, [&](JointId id) {
        return state.joints.body[state.jointSlots.dense(id)] != index;
    });
    body.clustersStale = true;
}

/// Angular joints follow their particles, in the order of the bodies. What is torn between two of
/// them goes.
void regroupAngles(State& state) {
    Angles& angles = state.angles;
    const auto& body = state.particles.body;
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
        angles.body[i] = body[angles.b[i]];
        if (body[angles.a[i]] == angles.body[i] && body[angles.c[i]] == angles.body[i])
            order.push_back(i);
        else
            state.angleSlots.erase(angles.id[i]);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) {
        return angles.body[i] < angles.body[k];
    });
    angles.forEachArray([&](auto& list) {
        const auto from = list;
        list.resize(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) list[i] = from[order[i]];
    });
    for (std::uint32_t i = 0; i < angles.size(); ++i) {
        state.angleSlots.move(angles.id[i], i);
        if (!angles.drive[i]) continue;
        Mechanism& drive = state.mechanisms.list[state.mechanisms.slots.dense(angles.drive[i])];
        drive.a = drive.b = state.bodies[angles.body[i]].id;
    }
}

/// A slider on a rail stays on its link, whoever has that now.
void regroupRails(State& state) {
    for (Mechanism& m : state.mechanisms.list)
        if (!m.rail.isNothing() && state.jointSlots.contains(m.rail.links[m.rail.link]))
            m.a = state.bodies[state.joints.body[state.jointSlots.dense(m.rail.links[m.rail.link])]]
                      .id;
}

/// Puts the particles of every body beside each other again, bodies in their order.
void reorderParticles(State& state) {
    std::vector<std::uint32_t> order;
    order.reserve(state.particles.size());
    for (BodyRecord& body : state.bodies) {
        const auto first = static_cast<std::uint32_t>(order.size());
        for (const ParticleId id : body.particles) order.push_back(state.particleSlots.dense(id));
        body.firstParticle = first;
    }
    std::vector<std::uint32_t> newIndex(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) newIndex[order[i]] = i;
    state.particles.forEachArray([&](auto& list) {
        auto moved = list;
        for (std::size_t i = 0; i < order.size(); ++i) moved[i] = list[order[i]];
        list = std::move(moved);
    });
    for (std::uint32_t i = 0; i < order.size(); ++i)
        state.particleSlots.move(state.particles.id[i], i);
    renumberParticles(state, newIndex);
}

/// Takes away particles, and bodies that have lost all of theirs.
void forgetLost(State& state, const std::vector<ParticleId>& lost) {
    Removal gone(state);
    for (const ParticleId id : lost) gone.particles[state.particleSlots.dense(id)] = true;
    for (std::uint32_t i = 0; i < state.bodies.size(); ++i) {
        const BodyRecord& body = state.bodies[i];
        const auto from = gone.particles.begin() + body.firstParticle;
        const auto to = from + static_cast<std::ptrdiff_t>(body.particles.size());
        gone.bodies[i] = std::find(from, to, false) == to;
    }
    compact(state, gone);
}

/// Bodies by their handles, with the headings of their frames when something broke.
using Frames = std::vector<std::pair<BodyId, Point>>;

/// What breaks keeps the frame of the body that it was of, also a single particle, which does not
/// show it.
void keepFrames(State& state, const Frames& frames) {
    for (const auto& [id, heading] : frames) {
        if (!state.bodySlots.contains(id)) continue;
        BodyRecord& body = state.bodies[state.bodySlots.dense(id)];
        body.turn = body.turnBefore = heading;
        const auto cluster = state.particles.cluster[body.firstParticle];
        if (body.particles.size() > 1 || cluster == none) continue;
        const Cluster& c = state.clusters.list[cluster];
        if (isDisc(c)) body.turn = body.turnBefore = turnedBack(c.heading, heading);
    }
}

}  // namespace

bool isAttached(const State& state, std::uint32_t particle) {
    return std::any_of(
        state.attachments.begin(), state.attachments.end(), [&](const Attachment& held) {
            return held.particle == particle || std::find(held.support.begin(), held.support.end(),
                                                          particle) != held.support.end();
        });
}

void splitBodies(State& state, const std::vector<ParticleId>& brokenEnds) {
    std::vector<std::uint32_t> ends, broken;
    for (const ParticleId id : brokenEnds) {
        ends.push_back(state.particleSlots.dense(id));
        broken.push_back(state.particles.body[ends.back()]);
    }
    for (auto* list : {&ends, &broken}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    Removal removal(state);
    Frames frames;
    bool anyLost = false, anySplit = false;
    for (const auto body : broken) {
        const Breakup result = breakUp(state, body, ends);
        const Point heading = frameOf(state, state.bodies[body]).heading;
        frames.emplace_back(state.bodies[body].id, heading);
        for (const auto i : result.lost) {
            removal.particles[i] = anyLost = true;
            state.events.particlesLost.push_back(
                {state.particles.id[i], state.bodies[body].id, state.particles.position[i]});
        }
        for (const auto& group : result.pieces) {
            makePiece(state, body, group);
            frames.emplace_back(state.bodies.back().id, heading);
        }
        anySplit |= !result.pieces.empty();
        if (!result.pieces.empty()) shrink(state, body);
    }
    std::vector<ParticleId> lost;
    for (std::size_t i = 0; i < removal.particles.size(); ++i)
        if (removal.particles[i]) lost.push_back(state.particles.id[i]);
    if (anySplit) {
        regroupAngles(state);
        regroupRails(state);
        reorderParticles(state);
    }
    if (anySplit) countTies(state);
    if (anyLost) forgetLost(state, lost);
    keepFrames(state, frames);
}

}  // namespace sulfur::detail
