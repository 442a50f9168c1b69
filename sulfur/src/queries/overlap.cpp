// Which bodies touch or enclose a shape.
#include <algorithm>

#include "bodies/impl.hpp"
#include "core/error_checks.hpp"
#include "queries/query.hpp"

namespace sulfur {

namespace detail {

namespace {

bool touches(const Collider& c, const QueryShape& shape) {
    return ConvexHull::difference(c.from, c.to, shape.points()).distance() <=
           static_cast<double>(c.radius) + shape.radius();
}

Overlap overlapWith(const State& state, const Collider& c) {
    return {state.bodies[c.body].id, c.joint == none ? JointId{} : state.joints.id[c.joint],
            state.particles.id[c.a]};
}

/// Each body with the first of its colliders that touches.
std::vector<Overlap> touching(const State& state, const QueryShape& shape,
                              const QueryFilter& filter) {
    const auto points = shape.points();
    Point low = points.front(), high = points.front();
    for (const Point& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Point margin(shape.radius(), shape.radius());
    std::vector<Collider> found;
    forEachColliderIn(state, low - margin, high + margin, [&](const Collider& c) {
        if (touches(c, shape) && admits(state, filter, c.body)) found.push_back(c);
    });
    std::sort(found.begin(), found.end(), [](const Collider& c, const Collider& d) {
        return std::tie(c.joint, c.a) < std::tie(d.joint, d.a);
    });
    std::vector<Overlap> overlaps;
    for (const Collider& c : found) overlaps.push_back(overlapWith(state, c));
    return overlaps;
}

void keepOneOfEach(std::vector<Overlap>& found) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Overlap& a, const Overlap& b) { return a.body < b.body; });
    found.erase(std::unique(found.begin(), found.end(),
                            [](const Overlap& a, const Overlap& b) { return a.body == b.body; }),
                found.end());
}

}  // namespace

}  // namespace detail

std::vector<Overlap> World::overlap(const QueryShape& shape, const QueryFilter& filter) const {
    detail::State& state = impl_->state();
    detail::prepareNearby(state);
    std::vector<Overlap> found = detail::touching(state, shape, filter);
    // What encloses a shape without touching it encloses each of its points.
    for (const auto body : detail::enclosing(state, shape.points().front(), filter))
        found.push_back({state.bodies[body].id, {}, {}});
    detail::keepOneOfEach(found);
    return found;
}

std::vector<Overlap> World::overlapBox(Point low, Point high, const QueryFilter& filter) const {
    detail::requireCoordinates(low, "lower corner of the box");
    detail::requireCoordinates(high, "upper corner of the box");
    if ((low.array() > high.array()).any())
        throw Error(ErrorCode::degenerate,
                    "the lower corner of the box is beyond the upper one; allowed is at most as "
                    "far right and as far up");
    const std::array corners{low, Point(high[0], low[1]), high, Point(low[0], high[1])};
    return overlap(QueryShape::polygon(corners), filter);
}

std::vector<Overlap> World::overlapCircle(Point centre, double radius,
                                          const QueryFilter& filter) const {
    return overlap(QueryShape::circle(centre, radius), filter);
}

std::vector<BodyId> World::bodiesIn(Point low, Point high, const QueryFilter& filter) const {
    std::vector<BodyId> found;
    for (const Overlap& hit : overlapBox(low, high, filter)) found.push_back(hit.body);
    const detail::State& state = impl_->state();
    const auto& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const detail::BodyRecord& body = state.bodies[p.body[i]];
        const Point& x = p.position[i];
        if (body.gone > 0 || (x.array() < low.array()).any() || (x.array() > high.array()).any())
            continue;
        if (!found.empty() && found.back() == body.id) continue;  // by another of its particles
        if (detail::admits(state, filter, p.body[i])) found.push_back(body.id);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<BodyId> World::bodiesAt(Point point, const QueryFilter& filter) const {
    std::vector<BodyId> found;
    for (const Overlap& hit : overlapCircle(point, 0, filter)) found.push_back(hit.body);
    return found;
}

}  // namespace sulfur
