#include <algorithm>
#include <map>
#include <quaoar/skin/body_shape.hpp>
#include <quaoar/skin/outline.hpp>
#include <set>

namespace quaoar {

using atlax::Vec2;

namespace {

using Index = std::uint32_t;

/// Who is tied to whom.
using Neighbours = std::vector<std::vector<Index>>;

bool tied(const Neighbours& neighbours, Index a, Index b) {
    return std::binary_search(neighbours[a].begin(), neighbours[a].end(), b);
}

void addTriangles(const Neighbours& neighbours, BodyShape& shape) {
    for (Index i = 0; i < neighbours.size(); ++i) {
        for (const Index j : neighbours[i]) {
            if (j < i) continue;
            for (const Index k : neighbours[i])
                if (k > j && tied(neighbours, j, k)) shape.triangles.push_back({i, j, k});
        }
    }
}

/// Meshes of four threads, each as two triangles.
void addMeshes(const Neighbours& neighbours, BodyShape& shape) {
    for (Index i = 0; i < neighbours.size(); ++i) {
        for (const Index a : neighbours[i]) {
            for (const Index b : neighbours[i]) {
                if (a <= i || b <= a) continue;
                for (const Index across : neighbours[a]) {
                    if (across == i || across < i || !tied(neighbours, across, b)) continue;
                    shape.triangles.push_back({i, a, across});
                    shape.triangles.push_back({i, across, b});
                }
            }
        }
    }
}

void orient(BodyShape& shape, const std::vector<Vec2>& places) {
    for (auto& t : shape.triangles) {
        if (cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]) < 0)
            std::swap(t[1], t[2]);
    }
}

void findBorder(BodyShape& shape, const Neighbours& neighbours) {
    std::set<BodyShape::Edge> sides;
    for (const auto& t : shape.triangles) {
        for (std::size_t k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
    }
    for (const auto& side : sides)
        if (!sides.contains({side[1], side[0]})) shape.border.push_back(side);
    for (Index i = 0; i < neighbours.size(); ++i) {
        for (const Index j : neighbours[i])
            if (i < j && !sides.contains({i, j}) && !sides.contains({j, i}))
                shape.loose.push_back({i, j});
    }
}

struct Frame {
    Vec2 low, size;
};

Frame frameOf(const sulfur::Blueprint& plan) {
    Frame frame{{1e9f, 1e9f}, {}};
    Vec2 high{-1e9f, -1e9f};
    for (const auto& particle : plan.particles) {
        const Vec2 p(particle.position);
        frame.low = {std::min(frame.low.x, p.x), std::min(frame.low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    frame.size = {std::max(high.x - frame.low.x, 0.01f), std::max(high.y - frame.low.y, 0.01f)};
    return frame;
}

void dress(const sulfur::World& world, sulfur::BodyId body, const sulfur::Blueprint* plan,
           BodyShape& shape) {
    const auto& skin = world.skin(body);
    const bool fits = skin && skin->uv.size() == shape.particles;
    if (skin) shape.texture = skin->texture;
    if (plan == nullptr) {
        for (std::size_t i = 0; i < shape.particles; ++i)
            shape.uv.push_back(fits ? Vec2(skin->uv[i]) : Vec2{0.5f, 0.5f});
        return;
    }
    const Frame frame = frameOf(*plan);
    shape.width = frame.size.x;
    shape.height = frame.size.y;
    const bool whole = plan->particles.size() == shape.particles;
    const auto particles = world.particles(body);
    for (std::size_t i = 0; i < shape.particles; ++i) {
        if (fits) {
            shape.uv.emplace_back(skin->uv[i]);
            continue;
        }
        // Pieces keep the frame of what they broke off from, and so the place in the picture.
        const Vec2 local = whole ? Vec2(plan->particles[i].position)
                                 : Vec2(world.toBody(body, world.position(particles[i])));
        const Vec2 part = local - frame.low;
        shape.uv.push_back({part.x / frame.size.x, 1 - part.y / frame.size.y});
    }
}

void sortUnique(Neighbours& neighbours) {
    for (auto& list : neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
}

void fill(const Neighbours& neighbours, BodyShape& shape, const std::vector<Vec2>& places) {
    addTriangles(neighbours, shape);
    if (shape.triangles.empty() && shape.joints > shape.particles + 2) addMeshes(neighbours, shape);
    orient(shape, places);
}

}  // namespace

bool BodyShape::fits(const sulfur::World& world, sulfur::BodyId body) const {
    return world.particles(body).size() == particles && world.joints(body).size() == joints;
}

BodyShape shapeOf(const sulfur::World& world, sulfur::BodyId body, const sulfur::Blueprint* plan) {
    const auto particles = world.particles(body);
    BodyShape shape;
    shape.particles = particles.size();
    shape.joints = world.joints(body).size();
    std::map<sulfur::ParticleId, Index> index;
    std::vector<Vec2> places;
    sulfur::Blueprint capsules;
    for (const sulfur::ParticleId particle : particles) {
        index.emplace(particle, static_cast<Index>(places.size()));
        places.emplace_back(world.position(particle));
        capsules.particles.push_back({.position = world.position(particle).cast<sulfur::Real>()});
    }
    Neighbours neighbours(particles.size());
    for (const sulfur::JointId joint : world.joints(body)) {
        const sulfur::JointInfo info = world.info(joint);
        const Index a = index[info.a], b = index[info.b];
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
        capsules.joints.push_back({.a = a, .b = b, .radius = info.radius});
        shape.thickness = std::max(shape.thickness, static_cast<float>(info.radius));
        shape.soft = shape.soft || info.stiffness < sulfur::Real(2e4);
    }
    sortUnique(neighbours);
    shape.outline = outlineOf(capsules);
    fill(neighbours, shape, places);
    findBorder(shape, neighbours);
    dress(world, body, plan, shape);
    return shape;
}

std::vector<std::array<std::uint32_t, 3>> trianglesOf(const sulfur::Blueprint& plan) {
    BodyShape shape;
    shape.particles = plan.particles.size();
    shape.joints = plan.joints.size();
    std::vector<Vec2> places;
    for (const auto& particle : plan.particles) places.emplace_back(particle.position);
    Neighbours neighbours(plan.particles.size());
    for (const auto& joint : plan.joints) {
        neighbours[joint.a].push_back(joint.b);
        neighbours[joint.b].push_back(joint.a);
    }
    sortUnique(neighbours);
    fill(neighbours, shape, places);
    return shape.triangles;
}

}  // namespace quaoar
