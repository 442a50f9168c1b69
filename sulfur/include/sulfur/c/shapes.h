/// \file
/// Ready-made blueprints; sulfur/shapes.hpp, which says what each is made of and gives the ranges.
///
/// Each function leaves a blueprint that is the caller's to destroy.
#ifndef SULFUR_C_SHAPES_H
#define SULFUR_C_SHAPES_H

#include <sulfur/c/base.h>
#include <sulfur/c/blueprint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A fixed line of capsules through points; sulfur::shapes::GroundOptions.
typedef struct SulfurGroundOptions {
    const SulfurVec* points;  ///< metres; the axes of the capsules
    size_t point_count;       ///< at least 2
    bool closed;              ///< also joins the last point to the first
    double radius;            ///< metres: half the thickness
    SulfurMaterial material;  ///< of the surface
    const double* bends;      ///< radians by which each capsule turns, or NULL: all are straight
    size_t bend_count;        ///< none, or as many as there are capsules
} SulfurGroundOptions;
/// Those of the C++ header; without points, which the caller gives.
SULFUR_API SulfurGroundOptions sulfur_ground_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_ground(const SulfurGroundOptions* options,
                                            SulfurBlueprint** blueprint);
/// A fixed straight floor from `from` to `to`, metres; `radius` is half its thickness.
SULFUR_API SulfurResult sulfur_shape_floor(SulfurVec from, SulfurVec to, double radius,
                                           SulfurBlueprint** blueprint);

/// A rectangle; sulfur::shapes::BoxOptions.
typedef struct SulfurBoxOptions {
    SulfurVec size;           ///< metres, outer
    double mass;              ///< kilograms
    double radius;            ///< metres: half the thickness of its sides
    double stiffness;         ///< N/m of every joint
    double damping;           ///< N s/m of every joint
    double strength;          ///< N of every joint
    bool solid_inertia;       ///< false: four corner particles alone, as in the paper
    bool rounded;             ///< whether the solid has its corners rounded by `radius`
    SulfurMaterial material;  ///< of the surface
} SulfurBoxOptions;
/// Those of the C++ header.
SULFUR_API SulfurBoxOptions sulfur_box_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_box(const SulfurBoxOptions* options,
                                         SulfurBlueprint** blueprint);

/// A convex or concave polygon; sulfur::shapes::PolygonOptions.
typedef struct SulfurPolygonOptions {
    const SulfurVec* points;  ///< metres, outer
    size_t point_count;       ///< 3 to 200
    double mass;              ///< kilograms
    double radius;            ///< metres: half the thickness of its sides
    double stiffness;         ///< N/m of every joint
    double damping;           ///< N s/m of every joint
    double strength;          ///< N of every joint
    bool rounded;             ///< whether the solid has its corners rounded by `radius`
    SulfurMaterial material;  ///< of the surface
} SulfurPolygonOptions;
/// Those of the C++ header; without points, which the caller gives.
SULFUR_API SulfurPolygonOptions sulfur_polygon_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_polygon(const SulfurPolygonOptions* options,
                                             SulfurBlueprint** blueprint);

/// A disc of one particle; sulfur::shapes::BallOptions.
typedef struct SulfurBallOptions {
    double radius;            ///< metres
    double mass;              ///< kilograms
    SulfurMaterial material;  ///< of the surface
} SulfurBallOptions;
/// Those of the C++ header.
SULFUR_API SulfurBallOptions sulfur_ball_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_ball(const SulfurBallOptions* options,
                                          SulfurBlueprint** blueprint);

/// A rim of rigid capsules around a hub; sulfur::shapes::WheelOptions.
typedef struct SulfurWheelOptions {
    double radius;            ///< metres, outer
    int32_t segments;         ///< particles on the rim
    double mass;              ///< kilograms in all
    double rim_radius;        ///< metres: half the thickness of the rim
    double spoke_stiffness;   ///< N/m of a spoke
    double spoke_damping;     ///< N s/m of a spoke
    double strength;          ///< N of every joint
    SulfurMaterial material;  ///< of the surface
} SulfurWheelOptions;
/// Those of the C++ header.
SULFUR_API SulfurWheelOptions sulfur_wheel_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_wheel(const SulfurWheelOptions* options,
                                           SulfurBlueprint** blueprint);

/// A line of equal links; sulfur::shapes::RopeOptions.
typedef struct SulfurRopeOptions {
    SulfurVec from;           ///< metres
    SulfurVec to;             ///< metres
    int32_t links;            ///< 0: as many as make links of about 5 cm
    bool has_slack;           ///< else 0.02 with both ends pinned, and 0 otherwise
    double slack;             ///< the share by which it is longer than the way
    double mass;              ///< kilograms in all
    double radius;            ///< metres; 0: it touches nothing
    double stiffness;         ///< N/m of a link
    double damping;           ///< N s/m of a link
    double bending;           ///< 0 (limp) to 100: how stiff it is against bending
    double bending_damping;   ///< 0 to 100: how strongly bending is damped
    double strength;          ///< N of a link
    bool pin_first;           ///< holds the particle at `from`
    bool pin_last;            ///< holds the particle at `to`
    SulfurMaterial material;  ///< of the surface
} SulfurRopeOptions;
/// Those of the C++ header.
SULFUR_API SulfurRopeOptions sulfur_rope_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_rope(const SulfurRopeOptions* options,
                                          SulfurBlueprint** blueprint);

/// A line of rigid links, longer, thicker and heavier than a rope's; sulfur::shapes::ChainOptions.
typedef struct SulfurChainOptions {
    SulfurVec from;           ///< metres
    SulfurVec to;             ///< metres
    int32_t links;            ///< 0: as many as make links of about 12 cm
    double mass;              ///< kilograms in all
    double radius;            ///< metres; 0: it touches nothing
    double strength;          ///< N of a link
    bool pin_first;           ///< holds the particle at `from`
    bool pin_last;            ///< holds the particle at `to`
    SulfurMaterial material;  ///< of the surface
} SulfurChainOptions;
/// Those of the C++ header.
SULFUR_API SulfurChainOptions sulfur_chain_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_chain(const SulfurChainOptions* options,
                                           SulfurBlueprint** blueprint);

/// Planks hung between two pins; sulfur::shapes::BridgeOptions.
typedef struct SulfurBridgeOptions {
    SulfurVec from;           ///< metres; a pin
    SulfurVec to;             ///< metres; a pin
    int32_t planks;           ///< 1 to 10000
    double sag;               ///< metres by which its middle hangs below the pins
    double mass;              ///< kilograms in all
    double radius;            ///< metres: half the thickness of a plank
    double stiffness;         ///< N/m of a plank
    double damping;           ///< N s/m of a plank
    double strength;          ///< N of a plank
    SulfurMaterial material;  ///< of the surface
} SulfurBridgeOptions;
/// Those of the C++ header.
SULFUR_API SulfurBridgeOptions sulfur_bridge_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_bridge(const SulfurBridgeOptions* options,
                                            SulfurBlueprint** blueprint);

/// A rectangular lattice of springs; sulfur::shapes::JellyOptions.
typedef struct SulfurJellyOptions {
    SulfurVec size;           ///< metres, outer
    int32_t columns;          ///< particles across
    int32_t rows;             ///< particles up
    double mass;              ///< kilograms in all
    double radius;            ///< metres: half the thickness of the outline
    double stiffness;         ///< N/m of a spring
    double damping;           ///< N s/m of a spring
    double strength;          ///< N of a spring
    SulfurMaterial material;  ///< of the surface
} SulfurJellyOptions;
/// Those of the C++ header.
SULFUR_API SulfurJellyOptions sulfur_jelly_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_jelly(const SulfurJellyOptions* options,
                                           SulfurBlueprint** blueprint);

/// A sheet hung by its upper corners; sulfur::shapes::ClothOptions.
typedef struct SulfurClothOptions {
    SulfurVec size;           ///< metres, outer
    int32_t columns;          ///< particles across
    int32_t rows;             ///< particles up
    double mass;              ///< kilograms in all
    double radius;            ///< metres; 0: it touches nothing
    bool diagonals;           ///< braces each mesh
    bool pin_corners;         ///< holds the two upper corners
    double stiffness;         ///< N/m of a spring
    double damping;           ///< N s/m of a spring
    double strength;          ///< N of a spring
    SulfurMaterial material;  ///< of the surface
} SulfurClothOptions;
/// Those of the C++ header.
SULFUR_API SulfurClothOptions sulfur_cloth_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_cloth(const SulfurClothOptions* options,
                                           SulfurBlueprint** blueprint);

/// A wall of braced cells that breaks; sulfur::shapes::WallOptions.
typedef struct SulfurWallOptions {
    SulfurVec size;           ///< metres, outer
    int32_t columns;          ///< cells across
    int32_t rows;             ///< cells up
    double mass;              ///< kilograms in all
    double radius;            ///< metres: half the thickness
    double stiffness;         ///< N/m of every joint
    double damping;           ///< N s/m of every joint
    double strength;          ///< N of every joint
    bool pin_bottom;          ///< holds the lowest row of particles
    SulfurMaterial material;  ///< of the surface
} SulfurWallOptions;
/// Those of the C++ header.
SULFUR_API SulfurWallOptions sulfur_wall_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_wall(const SulfurWallOptions* options,
                                          SulfurBlueprint** blueprint);

/// A round soft body; sulfur::shapes::BlobOptions.
typedef struct SulfurBlobOptions {
    double radius;            ///< metres, outer
    int32_t segments;         ///< particles on the ring
    double mass;              ///< kilograms in all
    double skin_radius;       ///< metres: half the thickness of the outline
    double stiffness;         ///< N/m of a spring
    double damping;           ///< N s/m of a spring
    SulfurMaterial material;  ///< of the surface
} SulfurBlobOptions;
/// Those of the C++ header.
SULFUR_API SulfurBlobOptions sulfur_blob_options_default(void);
/// Makes it.
SULFUR_API SulfurResult sulfur_shape_blob(const SulfurBlobOptions* options,
                                          SulfurBlueprint** blueprint);

#ifdef __cplusplus
}
#endif

#endif
