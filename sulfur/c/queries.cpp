// Questions about the geometry of a world.
#include "call.hpp"
#include "objects.hpp"

namespace sulfur::c {

extern "C" {

SulfurQueryFilter sulfur_query_filter_default(void) {
    const QueryFilter filter;
    return {filter.mask, toC(filter.ignore), filter.sensors, nullptr, nullptr};
}

SulfurQueryShape sulfur_query_shape_default(void) {
    SulfurQueryShape shape{};
    shape.count = 1;
    return shape;
}

SulfurResult sulfur_query_shape_circle(SulfurVec centre, double radius, SulfurQueryShape* shape) {
    return give(shape, [&] { return QueryShape::circle(point(centre), radius); });
}

SulfurResult sulfur_query_shape_capsule(SulfurVec a, SulfurVec b, double radius,
                                        SulfurQueryShape* shape) {
    return give(shape, [&] { return QueryShape::capsule(point(a), point(b), radius); });
}

SulfurResult sulfur_query_shape_box(SulfurVec centre, SulfurVec size, double angle,
                                    SulfurQueryShape* shape) {
    return give(shape, [&] { return QueryShape::box(point(centre), vec(size), angle); });
}

SulfurResult sulfur_query_shape_polygon(const SulfurVec* points, size_t count, double radius,
                                        SulfurQueryShape* shape) {
    return give(shape, [&] {
        std::vector<Point> corners;
        for (std::size_t i = 0; i < count; ++i)
            corners.push_back(point((&required(points, "points"))[i]));
        return QueryShape::polygon(corners, radius);
    });
}

SulfurResult sulfur_world_cast_segment(const SulfurWorld* world, SulfurVec from, SulfurVec to,
                                       const SulfurQueryFilter* filter, SulfurCastHit* hit,
                                       bool* found) {
    return giveIfAny(hit, found, [&] {
        return of(world).castSegment(point(from), point(to), orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_cast_ray(const SulfurWorld* world, SulfurVec from, SulfurVec direction,
                                   double reach, const SulfurQueryFilter* filter,
                                   SulfurCastHit* hit, bool* found) {
    return giveIfAny(hit, found, [&] {
        return of(world).castRay(point(from), vec(direction), reach,
                                 orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_cast_all(const SulfurWorld* world, SulfurVec from, SulfurVec to,
                                   const SulfurQueryFilter* filter, SulfurCastHit* out,
                                   size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).castAll(point(from), point(to), orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_cast_shape(const SulfurWorld* world, const SulfurQueryShape* shape,
                                     SulfurVec translation, const SulfurQueryFilter* filter,
                                     SulfurCastHit* hit, bool* found) {
    return giveIfAny(hit, found, [&] {
        return of(world).castShape(fromC(required(shape, "the shape")), point(translation),
                                   orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_closest_point(const SulfurWorld* world, SulfurVec place, double reach,
                                        const SulfurQueryFilter* filter,
                                        SulfurClosestPoint* closest, bool* found) {
    return giveIfAny(closest, found, [&] {
        return of(world).closestPoint(point(place), reach, orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_overlap(const SulfurWorld* world, const SulfurQueryShape* shape,
                                  const SulfurQueryFilter* filter, SulfurOverlap* out,
                                  size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).overlap(fromC(required(shape, "the shape")),
                                 orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_overlap_box(const SulfurWorld* world, SulfurVec low, SulfurVec high,
                                      const SulfurQueryFilter* filter, SulfurOverlap* out,
                                      size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).overlapBox(point(low), point(high), orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_overlap_circle(const SulfurWorld* world, SulfurVec centre, double radius,
                                         const SulfurQueryFilter* filter, SulfurOverlap* out,
                                         size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).overlapCircle(point(centre), radius, orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_bodies_at(const SulfurWorld* world, SulfurVec place,
                                    const SulfurQueryFilter* filter, SulfurBodyId* out,
                                    size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).bodiesAt(point(place), orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_bodies_in(const SulfurWorld* world, SulfurVec low, SulfurVec high,
                                    const SulfurQueryFilter* filter, SulfurBodyId* out,
                                    size_t capacity, size_t* count) {
    return giveList(out, capacity, count, [&] {
        return of(world).bodiesIn(point(low), point(high), orDefault<QueryFilter>(filter));
    });
}

SulfurResult sulfur_world_nearest_particle(const SulfurWorld* world, SulfurVec place, double reach,
                                           SulfurParticleId* particle, bool* found) {
    return giveIfAny(particle, found,
                     [&] { return of(world).nearestParticle(point(place), real(reach)); });
}

}  // extern "C"

}  // namespace sulfur::c
