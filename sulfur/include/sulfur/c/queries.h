/// \file
/// Questions about the geometry of a world; sulfur/queries.hpp, which says what they see.
///
/// Where at most one answer is possible, `found` tells whether there is one, and what would receive
/// it is untouched when there is none.
#ifndef SULFUR_C_QUERIES_H
#define SULFUR_C_QUERIES_H

#include <sulfur/c/base.h>
#include <sulfur/c/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Whether a query sees a body. It must not change the world.
typedef bool (*SulfurAcceptFunction)(void* user, SulfurBodyId body);

/// Restricts a query to some bodies; sulfur::QueryFilter.
typedef struct SulfurQueryFilter {
    uint32_t mask;                ///< bits of SulfurFilter::category, of which a body needs one
    SulfurBodyId ignore;          ///< a body that the query passes through; null: none
    bool sensors;                 ///< whether sensors are found too
    SulfurAcceptFunction accept;  ///< what else a body must be; null: nothing
    void* user;                   ///< what `accept` gets
} SulfurQueryFilter;
/// All but sensors.
SULFUR_API SulfurQueryFilter sulfur_query_filter_default(void);

/// Where something that moves along a straight way meets a surface; sulfur::CastHit.
typedef struct SulfurCastHit {
    SulfurBodyId body;          ///< what is hit
    SulfurJointId joint;        ///< the capsule that is hit; null when a disc is
    SulfurParticleId particle;  ///< the disc that is hit, or the capsule's nearer end
    SulfurVec point;            ///< on the surface, metres
    SulfurVec normal;           ///< unit length, out of the surface; zero if the way starts inside
    double fraction;            ///< of the way from start to end, 0 to 1
    double along;               ///< place along the hit capsule, 0 to 1
} SulfurCastHit;

/// The place of a surface that is nearest to a point; sulfur::ClosestPoint.
typedef struct SulfurClosestPoint {
    SulfurBodyId body;          ///< whose surface it is
    SulfurJointId joint;        ///< the capsule; null for a disc
    SulfurParticleId particle;  ///< the disc, or the capsule's nearer end
    SulfurVec point;            ///< on the surface, metres
    SulfurVec normal;           ///< unit length, out of the body
    double distance;            ///< metres; negative inside of the body
    double along;               ///< place along the capsule, 0 to 1
} SulfurClosestPoint;

/// A body that overlaps a region; sulfur::Overlap.
typedef struct SulfurOverlap {
    SulfurBodyId body;          ///< which it is
    SulfurJointId joint;        ///< a capsule of it that does, or null
    SulfurParticleId particle;  ///< a disc that does, or an end of the capsule, or null
} SulfurOverlap;

/// The most points that a shape may have.
#define SULFUR_MAX_SHAPE_POINTS 8

/// The convex hull of up to eight points, made thicker all round; sulfur::QueryShape.
typedef struct SulfurQueryShape {
    SulfurVec points[SULFUR_MAX_SHAPE_POINTS];  ///< metres
    uint32_t count;                             ///< of the points, 1 to 8
    double radius;                              ///< metres
} SulfurQueryShape;
/// A point at the origin.
SULFUR_API SulfurQueryShape sulfur_query_shape_default(void);
/// A disc.
SULFUR_API SulfurResult sulfur_query_shape_circle(SulfurVec centre, double radius,
                                                  SulfurQueryShape* shape);
/// What is within `radius` of the segment from `a` to `b`.
SULFUR_API SulfurResult sulfur_query_shape_capsule(SulfurVec a, SulfurVec b, double radius,
                                                   SulfurQueryShape* shape);
/// A rectangle around `centre`, turned counter-clockwise by `angle` radians.
SULFUR_API SulfurResult sulfur_query_shape_box(SulfurVec centre, SulfurVec size, double angle,
                                               SulfurQueryShape* shape);
/// The convex hull of 1 to 8 points, in any order, made thicker by `radius`.
SULFUR_API SulfurResult sulfur_query_shape_polygon(const SulfurVec* points, size_t count,
                                                   double radius, SulfurQueryShape* shape);

/// The first surface between two points; World::castSegment.
SULFUR_API SulfurResult sulfur_world_cast_segment(const SulfurWorld* world, SulfurVec from,
                                                  SulfurVec to, const SulfurQueryFilter* filter,
                                                  SulfurCastHit* hit, bool* found);
/// The first surface in a direction, at most `reach` metres away; World::castRay.
SULFUR_API SulfurResult sulfur_world_cast_ray(const SulfurWorld* world, SulfurVec from,
                                              SulfurVec direction, double reach,
                                              const SulfurQueryFilter* filter, SulfurCastHit* hit,
                                              bool* found);
/// All capsules and discs between two points, nearest first; World::castAll.
SULFUR_API SulfurResult sulfur_world_cast_all(const SulfurWorld* world, SulfurVec from,
                                              SulfurVec to, const SulfurQueryFilter* filter,
                                              SulfurCastHit* out, size_t capacity, size_t* count);
/// The first surface that a moved shape meets; World::castShape.
SULFUR_API SulfurResult sulfur_world_cast_shape(const SulfurWorld* world,
                                                const SulfurQueryShape* shape,
                                                SulfurVec translation,
                                                const SulfurQueryFilter* filter, SulfurCastHit* hit,
                                                bool* found);
/// The place of a surface that is nearest to a point; World::closestPoint.
SULFUR_API SulfurResult sulfur_world_closest_point(const SulfurWorld* world, SulfurVec point,
                                                   double reach, const SulfurQueryFilter* filter,
                                                   SulfurClosestPoint* closest, bool* found);
/// All bodies that touch or enclose a shape, by their handles, each once.
SULFUR_API SulfurResult sulfur_world_overlap(const SulfurWorld* world,
                                             const SulfurQueryShape* shape,
                                             const SulfurQueryFilter* filter, SulfurOverlap* out,
                                             size_t capacity, size_t* count);
/// The same for the upright rectangle between two corners.
SULFUR_API SulfurResult sulfur_world_overlap_box(const SulfurWorld* world, SulfurVec low,
                                                 SulfurVec high, const SulfurQueryFilter* filter,
                                                 SulfurOverlap* out, size_t capacity,
                                                 size_t* count);
/// The same for a disc.
SULFUR_API SulfurResult sulfur_world_overlap_circle(const SulfurWorld* world, SulfurVec centre,
                                                    double radius, const SulfurQueryFilter* filter,
                                                    SulfurOverlap* out, size_t capacity,
                                                    size_t* count);
/// All bodies that contain a point, by their handles.
SULFUR_API SulfurResult sulfur_world_bodies_at(const SulfurWorld* world, SulfurVec point,
                                               const SulfurQueryFilter* filter, SulfurBodyId* out,
                                               size_t capacity, size_t* count);
/// All bodies in an upright rectangle, by their handles, also those without a surface;
/// World::bodiesIn.
SULFUR_API SulfurResult sulfur_world_bodies_in(const SulfurWorld* world, SulfurVec low,
                                               SulfurVec high, const SulfurQueryFilter* filter,
                                               SulfurBodyId* out, size_t capacity, size_t* count);
/// The particle nearest to a point and at most `reach` metres away.
SULFUR_API SulfurResult sulfur_world_nearest_particle(const SulfurWorld* world, SulfurVec point,
                                                      double reach, SulfurParticleId* particle,
                                                      bool* found);

#ifdef __cplusplus
}
#endif

#endif
