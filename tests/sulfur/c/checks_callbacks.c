#include <math.h>
#include <string.h>

#include "check.h"
#include "checks.h"

/* What the callbacks of these checks know and note. */
typedef struct Asked {
    SulfurWorld* world;
    SulfurBodyId floor, ghost;
    int calls;
    const char* wrong;
    double restitution;
    SulfurPreSolveContact contact;
} Asked;

/* A floor at 0 and two balls above it. */
static const char* make(Asked* asked, SulfurBodyId balls[2]) {
    SulfurBlueprint* blueprint = NULL;
    int i;
    memset(asked, 0, sizeof *asked);
    OK(sulfur_world_create(NULL, &asked->world));
    OK(sulfur_shape_floor(v(-20, 0), v(20, 0), 0.05, &blueprint));
    OK(sulfur_world_add_body(asked->world, blueprint, at(0, 0, 0), &asked->floor));
    sulfur_blueprint_destroy(blueprint);
    OK(sulfur_shape_ball(NULL, &blueprint));
    for (i = 0; i < 2; ++i)
        OK(sulfur_world_add_body(asked->world, blueprint, at(2.0 * i, 1, 0), &balls[i]));
    sulfur_blueprint_destroy(blueprint);
    asked->ghost = balls[0];
    return NULL;
}

static const char* run(SulfurWorld* world, int ticks) {
    while (ticks-- > 0) OK(sulfur_world_step(world));
    return NULL;
}

/* Looking is allowed, and nothing else. */
static const char* check_inside(SulfurWorld* world, SulfurBodyId body) {
    SulfurPose pose;
    SulfurQueryFilter filter = sulfur_query_filter_default();
    uint64_t hash = 7;
    size_t count = 7;
    OK(sulfur_body_pose(world, body, &pose));
    CHECK(sulfur_body_apply_impulse(world, body, v(1, 0), v(0, 0)) == SULFUR_IN_CALLBACK);
    CHECK(strstr(sulfur_last_error(), "callback") != NULL);
    CHECK(sulfur_body_remove(world, body) == SULFUR_IN_CALLBACK);
    CHECK(sulfur_world_set_gravity(world, v(0, 0)) == SULFUR_IN_CALLBACK);
    CHECK(sulfur_world_set_pre_solve(world, NULL, NULL) == SULFUR_IN_CALLBACK);
    CHECK(sulfur_world_set_should_collide(world, NULL, NULL) == SULFUR_IN_CALLBACK);
    CHECK(sulfur_world_step(world) == SULFUR_IN_CALLBACK);
    CHECK(sulfur_world_hash(world, &hash) == SULFUR_IN_CALLBACK && hash == 7);
    CHECK(sulfur_world_bodies_at(world, v(0, 0), &filter, NULL, 0, &count) == SULFUR_IN_CALLBACK);
    CHECK(count == 7);
    return NULL;
}

static bool is_no_ghost(void* user, SulfurBodyId a, SulfurBodyId b) {
    Asked* asked = (Asked*)user;
    ++asked->calls;
    if (!asked->wrong) asked->wrong = check_inside(asked->world, b);
    if (a.index > b.index) asked->wrong = "the first body is the one with the larger handle";
    return b.index != asked->ghost.index;
}

/* One ball falls through the floor, the other does not. */
static const char* check_should_collide(Asked* asked, const SulfurBodyId balls[2]) {
    SulfurVec ghost, other;
    const char* wrong;
    OK(sulfur_world_set_should_collide(asked->world, is_no_ghost, asked));
    wrong = run(asked->world, 500);
    if (wrong) return wrong;
    if (asked->wrong) return asked->wrong;
    CHECK(asked->calls == 2);
    OK(sulfur_body_centre_of_mass(asked->world, balls[0], &ghost));
    OK(sulfur_body_centre_of_mass(asked->world, balls[1], &other));
    CHECK(ghost.y < -1 && fabs(other.y - 0.3) < 0.01);
    OK(sulfur_world_set_should_collide(asked->world, NULL, NULL));
    OK(sulfur_body_set_velocity(asked->world, balls[0], v(0, 0)));
    OK(sulfur_body_set_pose(asked->world, balls[0], at(0, 1, 0)));
    wrong = run(asked->world, 500);
    if (wrong) return wrong;
    OK(sulfur_body_centre_of_mass(asked->world, balls[0], &ghost));
    CHECK(asked->calls == 2 && fabs(ghost.y - 0.3) < 0.01);
    return NULL;
}

static bool rebounds(void* user, const SulfurPreSolveContact* contact, SulfurMaterial* surface) {
    Asked* asked = (Asked*)user;
    if (asked->calls++ == 0) asked->contact = *contact;
    if (!asked->wrong) asked->wrong = check_inside(asked->world, contact->b);
    surface->restitution = asked->restitution;
    return contact->b.index != asked->ghost.index;
}

/* Until they meet the floor; the ghost passes, the other one goes up again. */
static const char* check_pre_solve(Asked* asked, const SulfurBodyId balls[2]) {
    SulfurVec velocity, place;
    const char* wrong;
    int i;
    asked->calls = 0;
    asked->restitution = 1;
    for (i = 0; i < 2; ++i) {
        OK(sulfur_body_set_pose(asked->world, balls[i], at(2.0 * i, 0.4, 0)));
        OK(sulfur_body_set_velocity(asked->world, balls[i], v(0, -4)));
    }
    OK(sulfur_world_set_pre_solve(asked->world, rebounds, asked));
    wrong = run(asked->world, 50);
    if (wrong) return wrong;
    if (asked->wrong) return asked->wrong;
    CHECK(asked->calls > 1 && asked->contact.a.index == asked->floor.index);
    CHECK(asked->contact.normal.y < -0.999 && fabs(asked->contact.point.y - 0.1) < 0.06);
    CHECK(asked->contact.speed > 3.9 && asked->contact.gap < 0.11);
    OK(sulfur_body_mean_velocity(asked->world, balls[1], &velocity));
    OK(sulfur_body_centre_of_mass(asked->world, balls[0], &place));
    CHECK(velocity.y > 3 && place.y < 0.25);
    return NULL;
}

/* An answer that cannot be is told when the tick is over. */
static const char* check_bad_answer(Asked* asked, const SulfurBodyId balls[2]) {
    const char* broken = NULL;
    uint64_t before, after;
    int calls;
    asked->ghost.index = 0;
    OK(sulfur_body_set_pose(asked->world, balls[0], at(0, 0.301, 0)));
    OK(sulfur_body_set_velocity(asked->world, balls[0], v(0, -1)));
    OK(sulfur_world_ticks(asked->world, &before));
    asked->restitution = 7;
    CHECK(sulfur_world_step(asked->world) == SULFUR_OUT_OF_RANGE);
    CHECK(strstr(sulfur_last_error(), "restitution") != NULL);
    asked->restitution = NAN;
    CHECK(sulfur_world_step(asked->world) == SULFUR_NOT_FINITE);
    asked->restitution = 1e300;
    CHECK(sulfur_world_step(asked->world) == SULFUR_OUT_OF_RANGE);
    OK(sulfur_world_ticks(asked->world, &after));
    OK(sulfur_world_validate(asked->world, &broken));
    CHECK(after == before + 3 && broken[0] == '\0');
    asked->restitution = 0;
    OK(sulfur_world_step(asked->world));
    calls = asked->calls;
    OK(sulfur_world_set_pre_solve(asked->world, NULL, NULL));
    OK(sulfur_world_step(asked->world));
    CHECK(asked->calls == calls && !asked->wrong);
    CHECK(sulfur_world_set_pre_solve(NULL, rebounds, asked) == SULFUR_NULL_POINTER);
    CHECK(sulfur_world_set_should_collide(NULL, NULL, NULL) == SULFUR_NULL_POINTER);
    return NULL;
}

const char* c_check_callbacks(void) {
    Asked asked;
    SulfurBodyId balls[2];
    const char* wrong = make(&asked, balls);
    if (!wrong) wrong = check_should_collide(&asked, balls);
    if (!wrong) wrong = check_pre_solve(&asked, balls);
    if (!wrong) wrong = check_bad_answer(&asked, balls);
    sulfur_world_destroy(asked.world);
    return wrong;
}
