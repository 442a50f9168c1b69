#include "region.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "geometry.hpp"

namespace sulfurchamber {
namespace {

using sulfur::Point;

double ringArea(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        twice += sulfur::cross(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto side = [](const Point& p, const Point& q, const Point& r) {
        return sulfur::cross(q - p, r - p);
    };
    const bool boxes = std::max(a.x(), b.x()) >= std::min(c.x(), d.x()) &&
                       std::max(c.x(), d.x()) >= std::min(a.x(), b.x()) &&
                       std::max(a.y(), b.y()) >= std::min(c.y(), d.y()) &&
                       std::max(c.y(), d.y()) >= std::min(a.y(), b.y());
    return boxes && side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

bool outlinesMeet(const Outline& one, const Outline& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t j = 0; j < other.size(); ++j)
            if (segmentsMeet(one[i], one[(i + 1) % one.size()], other[j],
                             other[(j + 1) % other.size()]))
                return true;
    return false;
}

// Moments of one outline about the origin, with the sign of its sense of rotation.
struct OriginMoments {
    double area = 0;
    Point first{0, 0};
    double polar = 0;
};

OriginMoments originMoments(const Outline& outline) {
    OriginMoments sum;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& a = outline[i];
        const Point& b = outline[(i + 1) % outline.size()];
        const double twice = sulfur::cross(a, b);
        sum.area += twice / 2;
        sum.first += twice / 6 * (a + b);
        sum.polar += twice / 12 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
    }
    return sum;
}

std::vector<Point> pointsOf(const Region& region) {
    std::vector<Point> points = region.outer;
    for (const Outline& hole : region.holes) points.insert(points.end(), hole.begin(), hole.end());
    return points;
}

// The outer outline with a way to each hole and back, as places in the points of the region.
class Keyhole {
public:
    explicit Keyhole(const Region& region) : points_(pointsOf(region)) {
        ring_.resize(region.outer.size());
        std::iota(ring_.begin(), ring_.end(), 0u);
        std::vector<std::vector<std::uint32_t>> holes;
        auto next = static_cast<std::uint32_t>(region.outer.size());
        for (const Outline& hole : region.holes) {
            auto& places = holes.emplace_back(hole.size());
            std::iota(places.begin(), places.end(), next);
            next += static_cast<std::uint32_t>(hole.size());
        }
        // From the right: no hole lies between one and the outline then.
        const auto right = [&](const auto& places) {
            double most = points_[places[0]].x();
            for (const auto i : places) most = std::max(most, points_[i].x());
            return most;
        };
        std::sort(holes.begin(), holes.end(),
                  [&](const auto& a, const auto& b) { return right(a) > right(b); });
        for (std::size_t i = 0; i < holes.size(); ++i) bridge(holes, i);
    }

    // Both sides of each way are moved apart: the area is to the left of either.
    Outline opened(double width) const {
        Outline outline;
        for (const std::uint32_t i : ring_) outline.push_back(points_[i]);
        const Outline before = outline;
        const std::size_t count = ring_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = (i + 1) % count;
            const std::pair<std::uint32_t, std::uint32_t> way = std::minmax(ring_[i], ring_[next]);
            if (std::find(ways_.begin(), ways_.end(), way) == ways_.end()) continue;
            const Point along = (before[next] - before[i]).normalized();
            const Point left(-along.y(), along.x());
            outline[i] += width / 2 * left;
            outline[next] += width / 2 * left;
        }
        return outline;
    }

private:
    bool crossesRing(const std::vector<std::uint32_t>& ring, std::uint32_t a,
                     std::uint32_t b) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t c = ring[i];
            const std::uint32_t d = ring[(i + 1) % ring.size()];
            if (a == c || a == d || b == c || b == d) continue;
            if (segmentsMeet(points_[a], points_[b], points_[c], points_[d])) return true;
        }
        return false;
    }

    // Joins a hole to the ring by the shortest line that crosses nothing, from a corner that has
    // none yet.
    void bridge(const std::vector<std::vector<std::uint32_t>>& holes, std::size_t which) {
        const auto& hole = holes[which];
        struct Line {
            double length;
            std::size_t inRing;
            std::size_t inHole;
        };
        std::vector<Line> lines;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            if (std::count(ring_.begin(), ring_.end(), ring_[i]) > 1) continue;
            for (std::size_t k = 0; k < hole.size(); ++k)
                lines.push_back({(points_[ring_[i]] - points_[hole[k]]).squaredNorm(), i, k});
        }
        std::sort(lines.begin(), lines.end(),
                  [](const Line& a, const Line& b) { return a.length < b.length; });
        for (const Line& line : lines) {
            const std::uint32_t a = ring_[line.inRing];
            const std::uint32_t b = hole[line.inHole];
            bool free = !crossesRing(ring_, a, b);
            for (std::size_t other = which; other < holes.size() && free; ++other)
                free = !crossesRing(holes[other], a, b);
            if (!free) continue;
            std::vector<std::uint32_t> way;
            for (std::size_t k = 0; k <= hole.size(); ++k)
                way.push_back(hole[(line.inHole + k) % hole.size()]);
            way.push_back(a);
            ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(line.inRing) + 1, way.begin(),
                         way.end());
            ways_.emplace_back(std::minmax(a, b));
            return;
        }
        throw std::runtime_error("there is no way to one of its holes");
    }

    std::vector<Point> points_;
    std::vector<std::uint32_t> ring_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways_;
};

}  // namespace

std::vector<Region> regionsOf(const std::vector<Outline>& outlines, FillRule rule) {
    const auto filled = [rule](int winding, int crossings) {
        return rule == FillRule::nonzero ? winding != 0 : crossings % 2 != 0;
    };
    struct Hole {
        Outline outline;
        double area;
    };
    std::vector<Region> regions;
    std::vector<Hole> holes;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const double area = outlines[i].size() < 3 ? 0 : ringArea(outlines[i]);
        if (area == 0) continue;
        int winding = 0;
        int crossings = 0;
        for (std::size_t j = 0; j < outlines.size(); ++j) {
            if (j == i || outlines[j].size() < 3 || !inside(outlines[j], outlines[i][0])) continue;
            winding += ringArea(outlines[j]) > 0 ? 1 : -1;
            ++crossings;
        }
        const bool around = filled(winding, crossings);
        const bool within = filled(winding + (area > 0 ? 1 : -1), crossings + 1);
        if (around == within) continue;
        Outline outline = outlines[i];
        if ((area > 0) != within) std::reverse(outline.begin(), outline.end());
        if (within)
            regions.push_back({std::move(outline)});
        else
            holes.push_back({std::move(outline), std::abs(area)});
    }
    // The smallest area around a hole is the one that it is a hole of.
    for (Hole& hole : holes) {
        Region* around = nullptr;
        for (Region& region : regions)
            if (areaWithin(region.outer) > hole.area && inside(region.outer, hole.outline[0]) &&
                (around == nullptr || areaWithin(region.outer) < areaWithin(around->outer)))
                around = &region;
        if (around != nullptr) around->holes.push_back(std::move(hole.outline));
    }
    return regions;
}

AreaMoments momentsOf(const Region& region) {
    OriginMoments sum = originMoments(region.outer);
    for (const Outline& hole : region.holes) {
        const OriginMoments one = originMoments(hole);  // clockwise: negative
        sum.area += one.area;
        sum.first += one.first;
        sum.polar += one.polar;
    }
    const Point centre = sum.first / sum.area;
    return {sum.area, centre, sum.polar - sum.area * centre.squaredNorm()};
}

bool tangled(const Region& region) {
    if (meetsItself(region.outer)) return true;
    for (std::size_t i = 0; i < region.holes.size(); ++i) {
        if (meetsItself(region.holes[i]) || outlinesMeet(region.outer, region.holes[i]))
            return true;
        for (std::size_t k = 0; k < i; ++k)
            if (outlinesMeet(region.holes[i], region.holes[k])) return true;
    }
    return false;
}

Region simplified(const Region& region, double error) {
    Region result{simplified(region.outer, error, true)};
    for (const Outline& hole : region.holes) {
        Outline one = simplified(hole, error, true);
        if (one.size() > 2) result.holes.push_back(std::move(one));
    }
    return result;
}

Outline keyholed(const Region& region, double width) {
    if (region.holes.empty()) return region.outer;
    return Keyhole(region).opened(width);
}

}  // namespace sulfurchamber
