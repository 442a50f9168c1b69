/// \file
/// The world: its life, time, settings, state and threads; sulfur/world.hpp.
#ifndef SULFUR_C_WORLD_H
#define SULFUR_C_WORLD_H

#include <sulfur/c/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Where a field acts, or what is drawn.
typedef int32_t SulfurZoneKind;
/// Values of SulfurZoneKind.
enum {
    SULFUR_EVERYWHERE = 0,  ///< the whole world
    SULFUR_BOX_ZONE = 1,    ///< a rectangle, edges included
    SULFUR_CIRCLE_ZONE = 2  ///< a disc, edge included
};

/// A region; sulfur::Zone.
typedef struct SulfurZone {
    SulfurZoneKind kind;  ///< which of the following counts
    SulfurVec low;        ///< metres, of a box: lower left corner
    SulfurVec high;       ///< metres, of a box: upper right corner
    SulfurVec centre;     ///< metres, of a disc
    double radius;        ///< metres, of a disc
} SulfurZone;
/// Everywhere.
SULFUR_API SulfurZone sulfur_zone_default(void);

/// What the damper of an elastic joint brakes; sulfur::Damper.
typedef int32_t SulfurDamper;
/// Values of SulfurDamper.
enum {
    SULFUR_AXIAL_DAMPER = 0,  ///< stretching only
    SULFUR_FULL_DAMPER = 1    ///< all relative motion of its ends
};

/// How touching surfaces brake each other; sulfur::Friction.
typedef int32_t SulfurFriction;
/// Values of SulfurFriction.
enum {
    SULFUR_COULOMB_FRICTION = 0,  ///< Coulomb's
    SULFUR_SLIDING_FRICTION = 1   ///< the paper's, proportional to the sliding velocity
};

/// What a world is made with; sulfur::WorldSettings.
typedef struct SulfurWorldSettings {
    SulfurVec gravity;        ///< m/s^2
    double air_friction;      ///< 1/s, 0 to the tick rate
    int32_t tick_rate;        ///< Hz, 60 to 10000
    bool sleeping;            ///< whether islands at rest fall asleep
    SulfurDamper damper;      ///< of all elastic joints
    SulfurFriction friction;  ///< of all contacts
    bool tell_persisting;     ///< whether SulfurEvents::contacts_persisted is filled
    int32_t sweeps;           ///< 1 to 100 passes over the constraints in a step
    bool has_sleep_speed;     ///< else it follows gravity
    double sleep_speed;       ///< m/s, 0 to 2000: what stays slower falls asleep; 0: nothing does
    bool has_rebound_speed;   ///< else it follows gravity
    double rebound_speed;     ///< m/s, 0 to 2000: what meets slower does not rebound
} SulfurWorldSettings;
/// 500 ticks a second, gravity of the Earth.
SULFUR_API SulfurWorldSettings sulfur_world_settings_default(void);

/// Owns particles, joints and bodies and moves them; sulfur::World.
typedef struct SulfurWorld SulfurWorld;

/// An empty world, the caller's to destroy.
SULFUR_API SulfurResult sulfur_world_create(const SulfurWorldSettings* settings,
                                            SulfurWorld** world);
/// Another world in the same state, which goes on to the same bits; World::clone. Threads are lent
/// to one world: the new one has none.
SULFUR_API SulfurResult sulfur_world_clone(const SulfurWorld* world, SulfurWorld** clone);
/// Frees it with all that is in it. Null: nothing.
SULFUR_API void sulfur_world_destroy(SulfurWorld* world);

// --- time ---------------------------------------------------------------------------------------

/// Advances by exactly one tick. SULFUR_NO_MEMORY in its middle leaves a torn world, which is
/// refused with SULFUR_TORN until a snapshot is restored. It also returns, when the tick is over,
/// what callbacks answered wrong; callbacks.h.
SULFUR_API SulfurResult sulfur_world_step(SulfurWorld* world);
/// Ticks since the world was made.
SULFUR_API SulfurResult sulfur_world_ticks(const SulfurWorld* world, uint64_t* ticks);
/// Seconds since the world was made.
SULFUR_API SulfurResult sulfur_world_time(const SulfurWorld* world, double* seconds);
/// Seconds.
SULFUR_API SulfurResult sulfur_world_tick_duration(const SulfurWorld* world, double* seconds);

// --- settings -----------------------------------------------------------------------------------

/// What the world was made with; gravity, rate and air friction as they are now.
SULFUR_API SulfurResult sulfur_world_settings(const SulfurWorld* world,
                                              SulfurWorldSettings* settings);
/// m/s^2.
SULFUR_API SulfurResult sulfur_world_gravity(const SulfurWorld* world, SulfurVec* gravity);
/// m/s^2; wakes everything.
SULFUR_API SulfurResult sulfur_world_set_gravity(SulfurWorld* world, SulfurVec gravity);
/// 1/s.
SULFUR_API SulfurResult sulfur_world_air_friction(const SulfurWorld* world, double* air_friction);
/// 1/s, 0 to the tick rate.
SULFUR_API SulfurResult sulfur_world_set_air_friction(SulfurWorld* world, double air_friction);
/// Hz of the ticks to come.
SULFUR_API SulfurResult sulfur_world_set_tick_rate(SulfurWorld* world, int32_t tick_rate);
/// What dampers brake from now on.
SULFUR_API SulfurResult sulfur_world_set_damper(SulfurWorld* world, SulfurDamper damper);

// --- state --------------------------------------------------------------------------------------

/// Kinetic, gravitational and elastic energy of all dynamic bodies, joules; World::energy.
SULFUR_API SulfurResult sulfur_world_energy(const SulfurWorld* world, double* joules);
/// A hash of everything that decides how the world goes on.
SULFUR_API SulfurResult sulfur_world_hash(const SulfurWorld* world, uint64_t* hash);

/// The state of a world as bytes; sulfur::Snapshot.
typedef struct SulfurSnapshot SulfurSnapshot;
/// The whole state, the caller's to destroy; World::snapshot.
SULFUR_API SulfurResult sulfur_world_snapshot(const SulfurWorld* world, SulfurSnapshot** snapshot);
/// Its bytes, valid until it is destroyed.
SULFUR_API SulfurResult sulfur_snapshot_bytes(const SulfurSnapshot* snapshot, const void** bytes,
                                              size_t* size);
/// Frees it. Null: nothing.
SULFUR_API void sulfur_snapshot_destroy(SulfurSnapshot* snapshot);
/// Goes back to the state of a snapshot of the same build of the library, of this world or of
/// another one; World::restore. Bytes of any alignment.
SULFUR_API SulfurResult sulfur_world_restore(SulfurWorld* world, const void* bytes, size_t size);
/// Names the first broken invariant, or leaves an empty text. Valid until the next call of this
/// function for this world, or until the world is destroyed.
SULFUR_API SulfurResult sulfur_world_validate(const SulfurWorld* world, const char** broken);

// --- statistics ---------------------------------------------------------------------------------

/// The number of stages of a tick.
#define SULFUR_STAGE_COUNT 11
/// The name of a stage, 0 to SULFUR_STAGE_COUNT - 1; "?" for other numbers. Valid for ever.
SULFUR_API const char* sulfur_stage_name(int32_t stage);

/// What the last tick did; sulfur::Statistics, which says what each number counts.
typedef struct SulfurStatistics {
    uint32_t particles;                  ///< in the world
    uint32_t joints;                     ///< in the world
    uint32_t bodies;                     ///< in the world
    uint32_t awake_particles;            ///< of bodies that move
    uint32_t explicit_joints;            ///< elastic, integrated by NSV alone
    uint32_t implicit_joints;            ///< elastic, at least in part beyond the explicit range
    uint32_t rigid_joints;               ///< solved as constraints
    uint32_t swept_joints;               ///< of the implicit and rigid ones, those in no tree
    uint32_t explicit_angles;            ///< angular joints that are forces alone
    uint32_t implicit_angles;            ///< those that are constraints, at least in part
    uint32_t clusters;                   ///< rigid components awake
    uint32_t trees;                      ///< chains and trees awake that are solved directly
    uint32_t chain_steps;                ///< steps that these took
    uint32_t chains_in_lanes;            ///< of these trees, those that went side by side in lanes
    uint32_t chain_fallbacks;            ///< of these, those that gave up SHAKE directions
    uint32_t networks;                   ///< of the trees, those with loops
    uint32_t network_factors;            ///< factorisations that these took
    uint32_t triangles;                  ///< of soft bodies awake, which keep their side
    uint32_t pressed_triangles;          ///< of these, those nearly flat or turned over
    uint32_t candidates;                 ///< pairs of things near each other, one of them awake
    uint32_t looks;                      ///< at such pairs
    uint32_t contacts;                   ///< rows of contacts
    uint32_t boxes;                      ///< of the broad phase, drawn anew
    uint32_t substeps;                   ///< equal steps of a tick
    uint32_t damped_joints;              ///< of the explicit ones, those that brake
    uint32_t breakable_joints;           ///< awake ones that have a strength
    uint32_t fast_pairs;                 ///< of the candidates, those whose ways were looked at
    uint32_t held_back;                  ///< movers that were kept before what is in their way
    uint64_t idle_ticks;                 ///< since the world was made: no stage ran
    uint32_t items[SULFUR_STAGE_COUNT];  ///< by stage: what it looked at
    double seconds[SULFUR_STAGE_COUNT];  ///< by stage; zero unless profiling is on
} SulfurStatistics;
/// What the last tick did.
SULFUR_API SulfurResult sulfur_world_statistics(const SulfurWorld* world,
                                                SulfurStatistics* statistics);
/// Whether the time of each stage is measured too. It does not affect results.
SULFUR_API SulfurResult sulfur_world_set_profiling(SulfurWorld* world, bool on);

/// What a number of arrays of a world hold; sulfur::MemoryUse.
typedef struct SulfurMemoryUse {
    const char* name;  ///< in plain English; valid for ever
    size_t items;      ///< that it is counted by
    size_t bytes;      ///< in use
    bool hot;          ///< a tick reads or writes it for everything that is awake
} SulfurMemoryUse;
/// What the world holds in memory, part by part.
SULFUR_API SulfurResult sulfur_world_memory(const SulfurWorld* world, SulfurMemoryUse* out,
                                            size_t capacity, size_t* count);

// --- threads ------------------------------------------------------------------------------------

/// Threads for worlds; sulfur::ThreadPool.
typedef struct SulfurThreadPool SulfurThreadPool;
/// Threads of its own, the caller's to destroy: 1 to 32, 0: as many as the machine has.
SULFUR_API SulfurResult sulfur_thread_pool_create(size_t threads, SulfurThreadPool** pool);
/// Frees it. No world may have it any more. Null: nothing.
SULFUR_API void sulfur_thread_pool_destroy(SulfurThreadPool* pool);
/// Lends a world a pool; null: takes away whatever was lent. The pool must live until others are
/// lent or the world is destroyed.
SULFUR_API SulfurResult sulfur_world_set_thread_pool(SulfurWorld* world, SulfurThreadPool* pool);

/// How many threads may work at once, the caller's included; at least 1.
typedef size_t (*SulfurThreadsFunction)(void* user);
/// One piece of work.
typedef void (*SulfurTaskFunction)(void* context, size_t i);
/// Calls task(context, i) once for each i below `count`, in any order and at once, and returns when
/// all calls have returned.
typedef void (*SulfurRunFunction)(void* user, size_t count, SulfurTaskFunction task, void* context);
/// Microseconds that it takes to hand work over.
typedef double (*SulfurOverheadFunction)(void* user);
/// The tick is over.
typedef void (*SulfurRestFunction)(void* user);

/// A host's own job system; sulfur::Tasks.
typedef struct SulfurTasks {
    void* user;                       ///< what each function gets
    SulfurThreadsFunction threads;    ///< needed
    SulfurRunFunction run;            ///< needed
    SulfurOverheadFunction overhead;  ///< null: 5 microseconds
    SulfurRestFunction rest;          ///< null: nothing
} SulfurTasks;
/// No functions.
SULFUR_API SulfurTasks sulfur_tasks_default(void);
/// Lends a world a job system; null: takes away whatever was lent. The struct is copied; its
/// functions and `user` must stay until others are lent or the world is destroyed. A world is lent
/// one thing: a pool, or this.
SULFUR_API SulfurResult sulfur_world_set_tasks(SulfurWorld* world, const SulfurTasks* tasks);

#ifdef __cplusplus
}
#endif

#endif
