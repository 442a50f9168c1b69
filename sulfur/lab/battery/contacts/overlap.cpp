#include "battery/contacts/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace sulfur::lab {

namespace {

struct ThickLine {
    BodyId body;
    Point a, b;  // one place for a disc
    double radius;
};

/// The outer outline of a body: a walk round the graph of its capsules.
struct Outline {
    std::vector<Point> corners;  // empty for a body that encloses nothing
    double radius = 0;           // m, of its capsules
};

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

/// Whether two segments cross at an inner point of both.
bool cross(const ThickLine& s, const ThickLine& t) {
    const auto side = [](const Point& a, const Point& b, const Point& p) {
        return sulfur::cross(b - a, p - a);
    };
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
           side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0;
}

double depthOf(const ThickLine& s, const ThickLine& t) {
    const double apart =
        std::min({distanceToSegment(s.a, t.a, t.b), distanceToSegment(s.b, t.a, t.b),
                  distanceToSegment(t.a, s.a, s.b), distanceToSegment(t.b, s.a, s.b)});
    return s.radius + t.radius + (cross(s, t) ? apart : -apart);
}

class Collector final : public DebugDraw {
public:
    void capsule(const DebugDraw::Capsule& c) override {
        capsules.push_back({c.body, c.a, c.b, static_cast<double>(c.radius)});
    }
    void disc(const Disc& d) override {
        capsules.push_back({d.body, d.centre, d.centre, static_cast<double>(d.radius)});
    }
    std::vector<ThickLine> capsules;
};

/// The graph of one body's capsules.
struct Graph {
    std::vector<Point> places;
    std::vector<std::vector<std::size_t>> neighbours;
    double radius = 0;
};

Graph graphOf(const World& world, BodyId body) {
    Graph graph;
    std::map<ParticleId, std::size_t> number;
    const auto vertex = [&](ParticleId id) {
        const auto [at, fresh] = number.try_emplace(id, graph.places.size());
        if (fresh) {
            graph.places.push_back(world.position(id));
            graph.neighbours.emplace_back();
        }
        return at->second;
    };
    for (const JointId id : world.joints(body)) {
        const JointInfo joint = world.info(id);
        if (!(joint.radius > 0)) continue;
        const std::size_t a = vertex(joint.a), b = vertex(joint.b);
        graph.neighbours[a].push_back(b);
        graph.neighbours[b].push_back(a);
        graph.radius = std::max(graph.radius, static_cast<double>(joint.radius));
    }
    return graph;
}

/// The angle by which to turn counter-clockwise from `from` to `to`, above 0 up to a full turn.
double turn(const Point& from, const Point& to) {
    const double angle = std::atan2(sulfur::cross(from, to), from.dot(to));
    return angle > 1e-12 ? angle : angle + 2 * EIGEN_PI;
}

/// The outer face of the graph: from its lowest place always the first way counter-clockwise from
/// the one by which the walk came (the right hand stays on the outside).
Outline outlineOf(const World& world, BodyId body) {
    const Graph graph = graphOf(world, body);
    Outline outline;
    outline.radius = graph.radius;
    if (graph.places.size() < 3) return outline;
    const auto lowest = static_cast<std::size_t>(
        std::min_element(graph.places.begin(), graph.places.end(),
                         [](const Point& p, const Point& q) { return p.y() < q.y(); }) -
        graph.places.begin());
    const auto next = [&](std::size_t at, const Point& back) {
        return *std::min_element(graph.neighbours[at].begin(), graph.neighbours[at].end(),
                                 [&](std::size_t p, std::size_t q) {
                                     return turn(back, graph.places[p] - graph.places[at]) <
                                            turn(back, graph.places[q] - graph.places[at]);
                                 });
    };
    std::size_t at = next(lowest, Point(0, -1)), before = lowest;
    const std::size_t second = at;
    outline.corners.push_back(graph.places[lowest]);
    // A walk visits each side of each capsule once.
    for (std::size_t steps = 0; steps < 8 * graph.places.size(); ++steps) {
        outline.corners.push_back(graph.places[at]);
        const std::size_t following = next(at, graph.places[before] - graph.places[at]);
        before = at;
        at = following;
        if (before == lowest && at == second) break;
    }
    outline.corners.pop_back();
    return outline;
}

/// How deep `p` is within the outline's axes, m; negative outside.
double depthWithin(const Outline& outline, const Point& p) {
    if (windingNumber(outline.corners, p) == 0) return -1;
    double apart = std::numeric_limits<double>::max();
    const std::size_t n = outline.corners.size();
    for (std::size_t i = 0; i < n; ++i)
        apart =
            std::min(apart, distanceToSegment(p, outline.corners[i], outline.corners[(i + 1) % n]));
    return apart;
}

class Search {
public:
    Search(const World& world, const PairFilter& counts) : world_(world), counts_(counts) {
        Collector all;
        DrawOptions options;
        options.joints = options.particles = options.contacts = false;
        world.draw(all, options);
        capsules_ = std::move(all.capsules);
    }

    Overlap run() {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        for (const ThickLine& c : capsules_)
            if (!c.a.allFinite() || !c.b.allFinite()) return {none, none, c.body, c.body, c.a};
        std::sort(capsules_.begin(), capsules_.end(),
                  [](const ThickLine& s, const ThickLine& t) { return lowX(s) < lowX(t); });
        sweepCapsules();
        lookInside();
        return worst_;
    }

private:
    static double lowX(const ThickLine& c) { return std::min(c.a.x(), c.b.x()) - c.radius; }
    static double highX(const ThickLine& c) { return std::max(c.a.x(), c.b.x()) + c.radius; }

    bool wanted(BodyId a, BodyId b) const {
        return a != b &&
               (world_.kind(a) == BodyKind::dynamic || world_.kind(b) == BodyKind::dynamic) &&
               mayCollide(world_.filter(a), world_.filter(b)) && counts_(a, b);
    }

    void add(double depth, double radius, BodyId a, BodyId b, const Point& place) {
        if (depth <= 0 || depth / radius <= worst_.share) return;
        worst_ = {depth, depth / radius, a, b, place};
    }

    /// Sweep and prune along x.
    void sweepCapsules() {
        std::vector<std::size_t> open;
        for (std::size_t j = 0; j < capsules_.size(); ++j) {
            const ThickLine& t = capsules_[j];
            std::erase_if(open, [&](std::size_t i) { return highX(capsules_[i]) < lowX(t); });
            for (const std::size_t i : open) compare(capsules_[i], t);
            open.push_back(j);
        }
    }

    void compare(const ThickLine& s, const ThickLine& t) {
        const double reach = s.radius + t.radius;
        if (std::max(s.a.y(), s.b.y()) + reach < std::min(t.a.y(), t.b.y()) ||
            std::max(t.a.y(), t.b.y()) + reach < std::min(s.a.y(), s.b.y()))
            return;
        const double depth = depthOf(s, t);
        if (depth > 0 && wanted(s.body, t.body))
            add(depth, std::min(s.radius, t.radius), s.body, t.body, s.a);
    }

    /// Ends of capsules within solid bodies.
    void lookInside() {
        for (const BodyId body : world_.bodies()) {
            if (world_.kind(body) != BodyKind::dynamic) continue;
            const Outline outline = outlineOf(world_, body);
            if (outline.corners.size() < 3) continue;
            Point low = outline.corners.front(), high = low;
            for (const Point& p : outline.corners) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            for (const ThickLine& c : capsules_) {
                if (lowX(c) > high.x()) break;
                for (const Point& p : {c.a, c.b})
                    if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all())
                        lookAt(body, outline, c, p);
            }
        }
    }

    void lookAt(BodyId body, const Outline& outline, const ThickLine& c, const Point& p) {
        if (!wanted(body, c.body)) return;
        const double within = depthWithin(outline, p);
        if (within >= 0)
            add(within + outline.radius + c.radius, std::min(outline.radius, c.radius), c.body,
                body, p);
    }

    const World& world_;
    const PairFilter& counts_;
    std::vector<ThickLine> capsules_;
    Overlap worst_;
};

}  // namespace

int windingNumber(const std::vector<Point>& line, const Point& p) {
    int turns = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Point &a = line[i], &b = line[(i + 1) % line.size()];
        const bool above = a.y() > p.y();
        if (above == (b.y() > p.y())) continue;
        const double side = sulfur::cross(b - a, p - a);
        if (above ? side < 0 : side > 0) turns += above ? -1 : 1;
    }
    return turns;
}

Overlap deepestOverlap(const World& world, const PairFilter& counts) {
    return Search(world, counts).run();
}

double overlapOf(const World& world, BodyId a, BodyId b) {
    const PairFilter only = [&](BodyId x, BodyId y) {
        return (x == a && y == b) || (x == b && y == a);
    };
    return deepestOverlap(world, only).depth;
}

}  // namespace sulfur::lab
