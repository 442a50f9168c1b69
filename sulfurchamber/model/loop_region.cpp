#include "loop_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;
using Loop = std::vector<std::uint32_t>;

double signedArea(const Loop& loop, const std::vector<Point>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        twice += sulfur::cross(points[loop[i]], points[loop[(i + 1) % loop.size()]]);
    return twice / 2;
}

std::vector<Point> placesOf(const Loop& loop, const std::vector<Point>& points) {
    std::vector<Point> places;
    for (const std::uint32_t index : loop) places.push_back(points[index]);
    return places;
}

double turnOf(const Point& a, const Point& b, const Point& c) {
    return sulfur::cross(Point(b - a), Point(c - b));
}

bool segmentsCross(const Point& a, const Point& b, const Point& c, const Point& d) {
    return turnOf(a, b, c) * turnOf(a, b, d) < 0 && turnOf(c, d, a) * turnOf(c, d, b) < 0;
}

// An anticlockwise outline, and what is asked about it.
struct Outlined {
    const std::vector<Point>* points = nullptr;
    Loop loop;

    const Point& at(std::size_t i) const { return (*points)[loop[i % loop.size()]]; }
    std::size_t before(std::size_t i) const { return (i + loop.size() - 1) % loop.size(); }

    // Whether a way from its corner i begins inside of it.
    bool leadsInside(std::size_t i, const Point& to) const {
        const Point& a = at(before(i));
        const Point& b = at(i);
        const Point& c = at(i + 1);
        if (turnOf(a, b, c) > 0) return turnOf(a, b, to) > 0 && turnOf(b, c, to) > 0;
        return turnOf(a, b, to) > 0 || turnOf(b, c, to) > 0;
    }
    bool crosses(const Point& a, const Point& b) const {
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (segmentsCross(a, b, at(i), at(i + 1))) return true;
        return false;
    }
    // Whether the corner i is an ear: its triangle has no other corner in it.
    bool isEar(std::size_t i) const {
        const Point& a = at(before(i));
        const Point& b = at(i);
        const Point& c = at(i + 1);
        if (!(turnOf(a, b, c) > 0)) return false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Point& p = at(k);
            if (p == a || p == b || p == c) continue;
            if (turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0) return false;
        }
        return true;
    }
};

// The nearest corner of the outline that a corner of a hole sees, past all holes that are left.
std::optional<std::size_t> bridgeFrom(const Outlined& outline, const std::vector<Outlined>& holes,
                                      const Point& from) {
    std::optional<std::size_t> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.loop.size(); ++i) {
        const double distance = (outline.at(i) - from).norm();
        if (distance >= nearest || !outline.leadsInside(i, from) ||
            outline.crosses(from, outline.at(i)))
            continue;
        const bool blocked = std::any_of(holes.begin(), holes.end(), [&](const Outlined& hole) {
            return hole.crosses(from, outline.at(i));
        });
        if (blocked) continue;
        best = i;
        nearest = distance;
    }
    return best;
}

// The hole becomes a part of the outline, by a bridge there and back.
void join(Outlined& outline, std::size_t at, const Outlined& hole, std::size_t first) {
    Loop inserted;
    for (std::size_t k = 0; k <= hole.loop.size(); ++k)
        inserted.push_back(hole.loop[(first + k) % hole.loop.size()]);
    inserted.push_back(outline.loop[at]);
    outline.loop.insert(outline.loop.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                        inserted.begin(), inserted.end());
}

}  // namespace

std::vector<LoopRegion> regionsOfLoops(const std::vector<Loop>& loops, const std::vector<Point>& points) {
    std::vector<LoopRegion> regions;
    if (loops.size() == 1) return {{loops[0], {}}};
    // How many others each one lies in, and the smallest of these.
    std::vector<std::size_t> depth(loops.size(), 0);
    std::vector<std::size_t> parent(loops.size(), loops.size());
    std::vector<double> area;
    for (const Loop& loop : loops) area.push_back(std::abs(signedArea(loop, points)));
    for (std::size_t i = 0; i < loops.size(); ++i)
        for (std::size_t k = 0; k < loops.size(); ++k) {
            if (i == k || area[k] <= area[i]) continue;
            if (!inside(placesOf(loops[k], points), points[loops[i][0]])) continue;
            ++depth[i];
            if (parent[i] == loops.size() || area[k] < area[parent[i]]) parent[i] = k;
        }
    std::vector<std::size_t> place(loops.size(), 0);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (depth[i] % 2 == 1) continue;
        place[i] = regions.size();
        regions.push_back({loops[i], {}});
    }
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (depth[i] % 2 == 1) regions[place[parent[i]]].holes.push_back(loops[i]);
    return regions;
}

Loop oneLoop(const LoopRegion& region, const std::vector<Point>& points) {
    Outlined outline{&points, region.outer};
    if (signedArea(outline.loop, points) < 0)
        std::reverse(outline.loop.begin(), outline.loop.end());
    std::vector<Outlined> holes;
    for (const Loop& loop : region.holes) {
        holes.push_back({&points, loop});
        if (signedArea(loop, points) > 0)
            std::reverse(holes.back().loop.begin(), holes.back().loop.end());
    }
    while (!holes.empty()) {
        bool joined = false;
        for (std::size_t h = 0; h < holes.size() && !joined; ++h)
            for (std::size_t first = 0; first < holes[h].loop.size() && !joined; ++first) {
                const auto at = bridgeFrom(outline, holes, holes[h].at(first));
                if (!at) continue;
                join(outline, *at, holes[h], first);
                holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(h));
                joined = true;
            }
        if (!joined) return {};
    }
    return outline.loop;
}

std::vector<CornerTriple> trianglesOf(const LoopRegion& region, const std::vector<Point>& points) {
    Outlined outline{&points, oneLoop(region, points)};
    std::vector<CornerTriple> triangles;
    while (outline.loop.size() > 2) {
        std::size_t ear = 0;
        while (ear < outline.loop.size() && !outline.isEar(ear)) ++ear;
        if (ear == outline.loop.size()) return {};
        triangles.push_back({outline.loop[outline.before(ear)], outline.loop[ear],
                             outline.loop[(ear + 1) % outline.loop.size()]});
        outline.loop.erase(outline.loop.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

double areaOf(const LoopRegion& region, const std::vector<Point>& points) {
    double area = std::abs(signedArea(region.outer, points));
    for (const Loop& hole : region.holes) area -= std::abs(signedArea(hole, points));
    return area;
}

}  // namespace sulfurchamber
