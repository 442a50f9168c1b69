#include <quaoar/skin/outline.hpp>

#include <algorithm>

namespace quaoar {

using atlax::Vec2;

std::vector<std::uint32_t> outlineOf(const sulfur::Blueprint& blueprint) {
    std::vector<std::vector<std::uint32_t>> neighbours(blueprint.particles.size());
    std::size_t capsules = 0;
    for (const sulfur::JointSpec& joint : blueprint.joints) {
        if (!(joint.radius > 0)) continue;
        neighbours[joint.a].push_back(joint.b);
        neighbours[joint.b].push_back(joint.a);
        ++capsules;
    }
    std::uint32_t start = 0;
    while (start < neighbours.size() && neighbours[start].empty()) ++start;
    if (start == neighbours.size()) return {};
    std::vector<std::uint32_t> loop{start};
    std::uint32_t before = start, here = start;
    do {
        if (neighbours[here].size() != 2 || loop.size() > capsules) return {};
        const std::uint32_t next =
            neighbours[here][0] != before ? neighbours[here][0] : neighbours[here][1];
        before = here;
        here = next;
        if (here != start) loop.push_back(here);
    } while (here != start);
    if (loop.size() != capsules || loop.size() < 3) return {};
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& p = blueprint.particles[loop[i]].position;
        const auto& q = blueprint.particles[loop[(i + 1) % loop.size()]].position;
        area += static_cast<double>(p.x() * q.y() - p.y() * q.x());
    }
    if (area < 0) std::reverse(loop.begin(), loop.end());
    return loop;
}

std::vector<Vec2> cornerNormals(const std::vector<Vec2>& loop) {
    std::vector<Vec2> normals;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = normalized(loop[i] - loop[(i + n - 1) % n]);
        const Vec2 out = normalized(loop[(i + 1) % n] - loop[i]);
        normals.push_back(normalized(-perpendicular(in) - perpendicular(out)));
    }
    return normals;
}

std::vector<Vec2> grown(const std::vector<Vec2>& loop, float distance) {
    const std::vector<Vec2> normals = cornerNormals(loop);
    std::vector<Vec2> result;
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 edge = -perpendicular(normalized(loop[(i + 1) % n] - loop[i]));
        const float mitre = std::max(0.5f, dot(normals[i], edge));
        result.push_back(loop[i] + normals[i] * (distance / mitre));
    }
    return result;
}

}  // namespace quaoar
