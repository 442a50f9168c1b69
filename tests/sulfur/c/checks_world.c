#include <math.h>
#include <string.h>

#include "check.h"
#include "checks.h"

static bool is_not_crate(void* user, SulfurBodyId body) {
    return body.index != ((const SulfurBodyId*)user)->index;
}

/* A crate of 1 m at the origin and a ball beside it. */
static const char* make(SulfurWorld** world, SulfurBodyId* crate, SulfurBodyId* ball) {
    SulfurBlueprint* blueprint = NULL;
    OK(sulfur_world_create(NULL, world));
    OK(sulfur_shape_box(NULL, &blueprint));
    OK(sulfur_world_add_body(*world, blueprint, at(0, 0, 0), crate));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_shape_ball(NULL, &blueprint));
    OK(sulfur_world_add_body(*world, blueprint, at(3, 0, 0), ball));
    sulfur_blueprint_destroy(blueprint);
    return NULL;
}

static const char* check_casts(SulfurWorld* world, SulfurBodyId crate, SulfurBodyId ball) {
    SulfurQueryFilter filter = sulfur_query_filter_default();
    SulfurQueryShape shape = sulfur_query_shape_default();
    SulfurCastHit hit, hits[4];
    SulfurClosestPoint closest;
    size_t count;
    bool found;
    OK(sulfur_world_cast_segment(world, v(-5, 0), v(5, 0), NULL, &hit, &found));
    CHECK(found && hit.body.index == crate.index && fabs(hit.fraction - 0.45) < 1e-6);
    CHECK(hit.normal.x == -1 && fabs(hit.point.x + 0.5) < 1e-6);
    filter.accept = is_not_crate;
    filter.user = &crate;
    OK(sulfur_world_cast_segment(world, v(-5, 0), v(5, 0), &filter, &hit, &found));
    CHECK(found && hit.body.index == ball.index && hit.joint.index == 0);
    filter = sulfur_query_filter_default();
    filter.ignore = ball;
    OK(sulfur_world_cast_ray(world, v(5, 0), v(-2, 0), 100, &filter, &hit, &found));
    CHECK(found && hit.body.index == crate.index);
    hit.fraction = -7;
    OK(sulfur_world_cast_ray(world, v(5, 0), v(2, 0), 100, NULL, &hit, &found));
    CHECK(!found && hit.fraction == -7);
    OK(sulfur_world_cast_all(world, v(-5, 0), v(5, 0), NULL, hits, 4, &count));
    CHECK(count == 3 && hits[2].body.index == ball.index);
    OK(sulfur_query_shape_box(v(0, 5), v(1, 1), 0, &shape));
    CHECK(shape.count == 4);
    OK(sulfur_world_cast_shape(world, &shape, v(0, -10), NULL, &hit, &found));
    CHECK(found && fabs(hit.fraction - 0.4) < 1e-6);
    OK(sulfur_world_closest_point(world, v(3, 1), 5, NULL, &closest, &found));
    CHECK(found && closest.body.index == ball.index && fabs(closest.distance - 0.75) < 1e-6);
    return NULL;
}

static const char* check_overlaps(SulfurWorld* world, SulfurBodyId crate, SulfurBodyId ball) {
    const SulfurVec corners[3] = {{2, 0}, {4, 0}, {3, 1}};
    SulfurQueryShape shape;
    SulfurOverlap overlap;
    SulfurBodyId body, both[2];
    SulfurParticleId particle, centre;
    size_t count;
    bool found;
    OK(sulfur_query_shape_circle(v(0, 0), 0.1, &shape));
    OK(sulfur_world_overlap(world, &shape, NULL, &overlap, 1, &count));
    CHECK(count == 1 && overlap.body.index == crate.index && overlap.joint.index == 0);
    OK(sulfur_query_shape_capsule(v(2, 0), v(4, 0), 0.1, &shape));
    OK(sulfur_world_overlap(world, &shape, NULL, &overlap, 1, &count));
    CHECK(count == 1 && overlap.body.index == ball.index);
    OK(sulfur_query_shape_polygon(corners, 3, 0, &shape));
    OK(sulfur_world_overlap(world, &shape, NULL, &overlap, 1, &count));
    CHECK(count == 1 && shape.count == 3);
    OK(sulfur_world_overlap_box(world, v(-9, -9), v(9, 9), NULL, NULL, 0, &count));
    CHECK(count == 2);
    OK(sulfur_world_overlap_circle(world, v(9, 9), 1, NULL, NULL, 0, &count));
    CHECK(count == 0);
    OK(sulfur_world_bodies_at(world, v(3, 0), NULL, &body, 1, &count));
    CHECK(count == 1 && body.index == ball.index);
    OK(sulfur_world_bodies_in(world, v(-1, -1), v(4, 1), NULL, both, 2, &count));
    CHECK(count == 2 && both[0].index == crate.index && both[1].index == ball.index);
    OK(sulfur_world_nearest_particle(world, v(3, 0.5), 1, &particle, &found));
    OK(sulfur_body_particle(world, ball, 0, &centre));
    CHECK(found && particle.index == centre.index);
    return NULL;
}

const char* c_check_queries(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId crate, ball;
    const char* wrong = make(&world, &crate, &ball);
    if (!wrong) wrong = check_casts(world, crate, ball);
    if (!wrong) wrong = check_overlaps(world, crate, ball);
    sulfur_world_destroy(world);
    return wrong;
}

/* The ball of the scene breaks the wall; the jelly goes into no sensor, the crates into one. */
const char* c_check_events(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId crates[5], gate, visitors[9];
    SulfurBlueprint* blueprint = NULL;
    SulfurEvents events;
    size_t begun = 0, broken = 0, entered = 0, count;
    int i;
    const char* wrong = c_make_scene(&world, crates);
    if (wrong) return wrong;
    OK(sulfur_shape_ball(NULL, &blueprint));
    OK(sulfur_blueprint_set_kind(blueprint, SULFUR_FIXED));
    OK(sulfur_blueprint_set_sensor(blueprint, true));
    OK(sulfur_world_add_body(world, blueprint, at(-5, 1, 0), &gate));
    sulfur_blueprint_destroy(blueprint);
    for (i = 0; i < 500; ++i) {
        OK(sulfur_world_step(world));
        OK(sulfur_world_events(world, &events));
        begun += events.contacts_begun_count;
        broken += events.joints_broken_count;
        entered += events.sensors_entered_count;
        if (events.contacts_begun_count > 0) CHECK(events.contacts_begun[0].impulse > 0);
        if (events.joints_broken_count > 0) CHECK(events.joints_broken[0].force >= 300);
        if (events.sensors_entered_count > 0)
            CHECK(events.sensors_entered[0].sensor.index == gate.index);
        CHECK(events.contacts_persisted_count == 0);
    }
    CHECK(begun > 5 && broken > 0 && entered > 0);
    OK(sulfur_body_visitors(world, gate, visitors, 9, &count));
    CHECK(count >= 1);
    OK(sulfur_world_contacts(world, NULL, 0, &count));
    CHECK(count > 5);
    sulfur_world_destroy(world);
    return NULL;
}

/* From tick 100 on: restored and cloned, both go on as the first time. */
static const char* check_ways_on(SulfurWorld* world) {
    SulfurWorld* clone = NULL;
    SulfurSnapshot* snapshot = NULL;
    const void* bytes = NULL;
    uint64_t before, after, cloned;
    size_t size;
    int i;
    OK(sulfur_world_snapshot(world, &snapshot));
    OK(sulfur_world_clone(world, &clone));
    for (i = 0; i < 200; ++i) OK(sulfur_world_step(world));
    OK(sulfur_world_hash(world, &before));
    OK(sulfur_snapshot_bytes(snapshot, &bytes, &size));
    OK(sulfur_world_restore(world, bytes, size));
    for (i = 0; i < 200; ++i) {
        OK(sulfur_world_step(world));
        OK(sulfur_world_step(clone));
    }
    OK(sulfur_world_hash(world, &after));
    OK(sulfur_world_hash(clone, &cloned));
    CHECK(after == before && cloned == before);
    CHECK(sulfur_world_restore(world, bytes, size - 1) == SULFUR_BAD_SNAPSHOT);
    CHECK(sulfur_world_restore(world, bytes, 0) == SULFUR_BAD_SNAPSHOT);
    sulfur_snapshot_destroy(snapshot);
    sulfur_world_destroy(clone);
    return NULL;
}

/* What is given comes back, and what is not given stays so. */
static const char* check_speeds(void) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurWorld* world = NULL;
    CHECK(!settings.has_sleep_speed && !settings.has_rebound_speed);
    settings.has_sleep_speed = true;
    settings.sleep_speed = 0.25;
    OK(sulfur_world_create(&settings, &world));
    OK(sulfur_world_settings(world, &settings));
    CHECK(settings.has_sleep_speed && settings.sleep_speed == 0.25 && !settings.has_rebound_speed);
    sulfur_world_destroy(world);
    settings.has_sleep_speed = false;
    settings.has_rebound_speed = true;
    settings.rebound_speed = 0.5;
    OK(sulfur_world_create(&settings, &world));
    OK(sulfur_world_settings(world, &settings));
    CHECK(!settings.has_sleep_speed && settings.has_rebound_speed && settings.rebound_speed == 0.5);
    sulfur_world_destroy(world);
    return NULL;
}

/* After tick 300. */
static const char* check_numbers_of_world(const SulfurWorld* world) {
    SulfurStatistics statistics;
    SulfurMemoryUse memory[64];
    const char* broken = NULL;
    double energy, seconds;
    uint64_t ticks;
    size_t count;
    OK(sulfur_world_validate(world, &broken));
    CHECK(broken[0] == '\0');
    OK(sulfur_world_ticks(world, &ticks));
    OK(sulfur_world_time(world, &seconds));
    CHECK(ticks == 300 && fabs(seconds - 0.6) < 1e-12);
    OK(sulfur_world_tick_duration(world, &seconds));
    CHECK(fabs(seconds - 0.002) < 1e-9);
    OK(sulfur_world_energy(world, &energy));
    CHECK(isfinite(energy) && energy > 0);
    OK(sulfur_world_statistics(world, &statistics));
    CHECK(statistics.bodies >= 10 && statistics.contacts > 0 && statistics.substeps == 1);
    CHECK(statistics.seconds[6] > 0 && strcmp(sulfur_stage_name(6), "constraints") == 0);
    CHECK(strcmp(sulfur_stage_name(SULFUR_STAGE_COUNT), "?") == 0);
    OK(sulfur_world_memory(world, memory, 64, &count));
    CHECK(count > 5 && count <= 64 && strlen(memory[0].name) > 0);
    return NULL;
}

static const char* check_settings(SulfurWorld* world) {
    SulfurWorldSettings settings;
    SulfurVec gravity;
    double air_friction;
    OK(sulfur_world_set_gravity(world, v(1, 2)));
    OK(sulfur_world_set_air_friction(world, 0.5));
    OK(sulfur_world_set_tick_rate(world, 100));
    OK(sulfur_world_set_damper(world, SULFUR_FULL_DAMPER));
    OK(sulfur_world_settings(world, &settings));
    CHECK(settings.gravity.y == 2 && settings.air_friction == 0.5 && settings.tick_rate == 100);
    CHECK(settings.damper == SULFUR_FULL_DAMPER && settings.sleeping && settings.sweeps == 4);
    OK(sulfur_world_gravity(world, &gravity));
    OK(sulfur_world_air_friction(world, &air_friction));
    CHECK(gravity.x == 1 && air_friction == 0.5);
    return NULL;
}

const char* c_check_state(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId crates[5];
    int i;
    const char* wrong = c_make_scene(&world, crates);
    if (wrong) return wrong;
    OK(sulfur_world_set_profiling(world, true));
    for (i = 0; i < 100; ++i) OK(sulfur_world_step(world));
    wrong = check_ways_on(world);
    if (!wrong) wrong = check_numbers_of_world(world);
    if (!wrong) wrong = check_settings(world);
    if (!wrong) wrong = check_speeds();
    sulfur_world_destroy(world);
    return wrong;
}

/* How often each function was called. */
typedef struct Counts {
    int bodies, particles, discs, joints, capsules, contacts, attachments, fields, grabs,
        mechanisms;
    double drag;
    SulfurVec support;
} Counts;

static void count_body(void* user, const SulfurDrawnBody* body) {
    ((Counts*)user)->bodies += body->id.index != 0 && body->low.x < body->high.x;
}
static void count_particle(void* user, const SulfurDrawnParticle* particle) {
    ((Counts*)user)->particles += particle->id.index != 0;
}
static void count_disc(void* user, const SulfurDrawnDisc* disc) {
    ((Counts*)user)->discs += disc->radius == 0.25;
}
static void count_joint(void* user, const SulfurDrawnJoint* joint) {
    ((Counts*)user)->joints += joint->stiffness > 0;
}
static void count_capsule(void* user, const SulfurDrawnCapsule* capsule) {
    ((Counts*)user)->capsules += capsule->radius > 0;
}
static void count_contact(void* user, const SulfurContactInfo* contact) {
    ((Counts*)user)->contacts += contact->a.index != 0;
}
static void count_attachment(void* user, const SulfurDrawnAttachment* attachment) {
    ((Counts*)user)->attachments += (int)attachment->count;
    ((Counts*)user)->support = attachment->supports[0];
}
static void count_field(void* user, const SulfurDrawnField* field) {
    ((Counts*)user)->fields += field->field.kind == SULFUR_WIND_FIELD;
    ((Counts*)user)->drag = field->field.wind.drag;
}
static void count_grab(void* user, const SulfurDrawnGrab* grab) {
    ((Counts*)user)->grabs += grab->info.target.y == 4;
}

static void count_mechanism(void* user, const SulfurDrawnMechanism* mechanism) {
    ((Counts*)user)->mechanisms += mechanism->info.kind == SULFUR_DISTANCE &&
                                   mechanism->count == 2 && mechanism->places[0].x < -4;
}

const char* c_check_draw(void) {
    SulfurWorld* world = NULL;
    SulfurBodyId crates[5];
    SulfurDebugDraw draw = sulfur_debug_draw_default();
    SulfurDrawOptions options = sulfur_draw_options_default();
    SulfurStatistics statistics;
    SulfurMechanismId rod;
    Counts counts;
    const char* wrong = c_make_scene(&world, crates);
    if (wrong) return wrong;
    OK(sulfur_world_distance(world, crates[0], v(-5, 0.6), crates[1], v(-5, 1.7), NULL, &rod));
    OK(sulfur_world_step(world));
    OK(sulfur_world_statistics(world, &statistics));
    memset(&counts, 0, sizeof counts);
    OK(sulfur_world_draw(world, &draw, NULL));
    draw.user = &counts;
    draw.body = count_body;
    draw.particle = count_particle;
    draw.disc = count_disc;
    draw.joint = count_joint;
    draw.capsule = count_capsule;
    draw.contact = count_contact;
    draw.attachment = count_attachment;
    draw.field = count_field;
    draw.grab = count_grab;
    draw.mechanism = count_mechanism;
    OK(sulfur_world_draw(world, &draw, NULL));
    CHECK(counts.bodies >= 10 && counts.particles == (int)statistics.particles);
    CHECK(counts.discs == 1 && counts.joints == (int)statistics.joints && counts.capsules > 20);
    CHECK(counts.attachments >= 1 && counts.attachments <= 3 && counts.support.y > 6);
    CHECK(counts.fields == 1 && counts.drag == 0.125 && counts.grabs == 1);
    CHECK(counts.mechanisms == 1);
    memset(&counts, 0, sizeof counts);
    options.particles = false;
    options.view.kind = SULFUR_CIRCLE_ZONE;
    options.view.centre = v(-5, 0.6);
    options.view.radius = 0.9;
    OK(sulfur_world_draw(world, &draw, &options));
    CHECK(counts.particles == 0 && counts.bodies >= 1 && counts.bodies <= 3);
    options.alpha = 2;
    CHECK(sulfur_world_draw(world, &draw, &options) == SULFUR_OUT_OF_RANGE);
    sulfur_world_destroy(world);
    return NULL;
}

/* What is no world, or none that can be made. */
static const char* check_worlds(void) {
    SulfurWorldSettings settings = sulfur_world_settings_default();
    SulfurWorld* world = NULL;
    settings.tick_rate = 3;
    CHECK(sulfur_world_create(&settings, &world) == SULFUR_OUT_OF_RANGE && world == NULL);
    CHECK(strstr(sulfur_last_error(), "tick rate") != NULL);
    settings = sulfur_world_settings_default();
    settings.friction = 2;
    CHECK(sulfur_world_create(&settings, &world) == SULFUR_OUT_OF_RANGE);
    CHECK(strstr(sulfur_last_error(), "friction") != NULL);
    settings = sulfur_world_settings_default();
    settings.has_sleep_speed = true;
    settings.sleep_speed = -1;
    CHECK(sulfur_world_create(&settings, &world) == SULFUR_OUT_OF_RANGE);
    settings.has_sleep_speed = false;
    settings.has_rebound_speed = true;
    settings.rebound_speed = 2001;
    CHECK(sulfur_world_create(&settings, &world) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_world_create(NULL, NULL) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_set_gravity(NULL, v(0, 0)) == SULFUR_NULL_POINTER);
    CHECK(strstr(sulfur_last_error(), "the world is null") != NULL);
    CHECK(strcmp(sulfur_result_name(SULFUR_STALE_HANDLE), "stale handle") == 0);
    CHECK(strcmp(sulfur_result_name(99), "?") == 0);
    sulfur_world_destroy(NULL);
    sulfur_blueprint_destroy(NULL);
    sulfur_snapshot_destroy(NULL);
    sulfur_thread_pool_destroy(NULL);
    return NULL;
}

static const char* check_numbers(SulfurWorld* world) {
    SulfurField field = sulfur_field_default(SULFUR_UNIFORM_FIELD);
    SulfurQueryShape shape = sulfur_query_shape_default();
    SulfurBodyId body = {3, 4}, none = {0, 0};
    SulfurFieldId id = {5, 6};
    SulfurVec place = {7, 8};
    size_t count = 9;
    CHECK(sulfur_body_centre_of_mass(world, body, &place) == SULFUR_STALE_HANDLE);
    CHECK(strstr(sulfur_last_error(), "3:4") != NULL && place.x == 7);
    CHECK(sulfur_body_remove(world, none) == SULFUR_STALE_HANDLE);
    CHECK(sulfur_world_set_gravity(world, v(NAN, 0)) == SULFUR_NOT_FINITE);
    CHECK(sulfur_world_set_gravity(world, v(0, 1e300)) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_world_set_damper(world, -1) == SULFUR_OUT_OF_RANGE);
    field.kind = 3;
    CHECK(sulfur_world_add_field(world, &field, &id) == SULFUR_OUT_OF_RANGE && id.index == 5);
    field = sulfur_field_default(SULFUR_UNIFORM_FIELD);
    field.uniform.zone.kind = 9;
    CHECK(sulfur_world_add_field(world, &field, &id) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_world_add_field(world, NULL, &id) == SULFUR_NULL_POINTER);
    shape.count = 9;
    CHECK(sulfur_world_overlap(world, &shape, NULL, NULL, 0, &count) == SULFUR_OUT_OF_RANGE);
    CHECK(count == 9);
    shape.count = 0;
    CHECK(sulfur_world_overlap(world, &shape, NULL, NULL, 0, &count) == SULFUR_OUT_OF_RANGE);
    return NULL;
}

static const char* check_pointers(SulfurWorld* world) {
    SulfurBoxOptions box = sulfur_box_options_default();
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId body;
    size_t count;
    bool found;
    CHECK(sulfur_world_bodies(world, NULL, 1, &count) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_bodies(world, NULL, 0, NULL) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_nearest_particle(world, v(0, 0), 1, NULL, &found) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_restore(world, NULL, 4) == SULFUR_NULL_POINTER);
    box.mass = -1;
    CHECK(sulfur_shape_box(&box, &blueprint) == SULFUR_OUT_OF_RANGE && blueprint == NULL);
    CHECK(sulfur_shape_ground(NULL, &blueprint) != SULFUR_OK && blueprint == NULL);
    OK(sulfur_shape_box(NULL, &blueprint));
    CHECK(sulfur_world_add_body(world, blueprint, at(0, 0, 0), NULL) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_add_body(world, NULL, at(0, 0, 0), &body) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_add_body(world, blueprint, at(1e30, 0, 0), &body) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_blueprint_set_kind(blueprint, 7) == SULFUR_OUT_OF_RANGE);
    CHECK(sulfur_blueprint_set_name(blueprint, NULL) == SULFUR_NULL_POINTER);
    sulfur_blueprint_destroy(blueprint);
    return NULL;
}

const char* c_check_errors(void) {
    SulfurWorld* world = NULL;
    uint64_t before, after;
    const char* wrong = check_worlds();
    if (wrong) return wrong;
    OK(sulfur_world_create(NULL, &world));
    OK(sulfur_world_hash(world, &before));
    wrong = check_numbers(world);
    if (!wrong) wrong = check_pointers(world);
    OK(sulfur_world_hash(world, &after));
    CHECK(wrong || after == before);
    sulfur_world_destroy(world);
    return wrong;
}

static size_t two(void* user) {
    (void)user;
    return 2;
}
static void run_backwards(void* user, size_t count, SulfurTaskFunction task, void* context) {
    ++*(int*)user;
    while (count-- > 0) task(context, count);
}
static double no_overhead(void* user) {
    (void)user;
    return 0.01;
}

/* A pool and functions of the host change nothing but who works. */
const char* c_check_threads(void) {
    SulfurWorld *alone = NULL, *pooled = NULL, *lent = NULL;
    SulfurThreadPool* pool = NULL;
    SulfurTasks tasks = sulfur_tasks_default();
    SulfurBlueprint* blueprint = NULL;
    SulfurBodyId body;
    uint64_t a, b, c;
    int i, runs = 0;
    OK(sulfur_world_create(NULL, &alone));
    OK(sulfur_shape_jelly(NULL, &blueprint));
    for (i = 0; i < 200; ++i)
        OK(sulfur_world_add_body(alone, blueprint, at(2.0 * i, 0.1 * (i % 7), 0.1 * i), &body));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_world_clone(alone, &pooled));
    OK(sulfur_world_clone(alone, &lent));
    OK(sulfur_thread_pool_create(2, &pool));
    OK(sulfur_world_set_thread_pool(pooled, pool));
    CHECK(sulfur_world_set_tasks(lent, &tasks) == SULFUR_NULL_POINTER);
    tasks.user = &runs;
    tasks.threads = two;
    tasks.run = run_backwards;
    tasks.overhead = no_overhead;
    OK(sulfur_world_set_tasks(lent, &tasks));
    for (i = 0; i < 20; ++i) {
        OK(sulfur_world_step(alone));
        OK(sulfur_world_step(pooled));
        OK(sulfur_world_step(lent));
    }
    CHECK(runs > 0);
    OK(sulfur_world_hash(alone, &a));
    OK(sulfur_world_hash(pooled, &b));
    OK(sulfur_world_hash(lent, &c));
    CHECK(a == b && a == c);
    runs = 0;
    OK(sulfur_world_set_tasks(lent, NULL));
    OK(sulfur_world_set_thread_pool(pooled, NULL));
    sulfur_thread_pool_destroy(pool);
    CHECK(sulfur_thread_pool_create(1000, &pool) == SULFUR_OUT_OF_RANGE);
    OK(sulfur_world_step(lent));
    OK(sulfur_world_step(pooled));
    CHECK(runs == 0);
    sulfur_world_destroy(alone);
    sulfur_world_destroy(pooled);
    sulfur_world_destroy(lent);
    return NULL;
}
