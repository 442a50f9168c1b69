/* A crate falls onto a floor and comes to rest: hello.cpp in C. */
#include <stdio.h>
#include <stdlib.h>
#include <sulfur/c/sulfur.h>

/* Ends the program with the library's own words. */
static void must(SulfurResult result) {
    if (result == SULFUR_OK) return;
    fprintf(stderr, "hello: %s\n", sulfur_last_error());
    exit(1);
}

int main(void) {
    const SulfurVec left = {-20, 0}, right = {20, 0};
    const SulfurPose origin = {{0, 0}, 0}, above = {{0, 3}, 0};
    SulfurBoxOptions box = sulfur_box_options_default();
    SulfurBlueprint *floor, *plan;
    SulfurBodyId ground, crate;
    SulfurWorld* world;
    must(sulfur_world_create(NULL, &world));
    must(sulfur_shape_floor(left, right, 0.05, &floor));
    must(sulfur_world_add_body(world, floor, origin, &ground));
    sulfur_blueprint_destroy(floor);
    box.mass = 2;
    must(sulfur_shape_box(&box, &plan));
    must(sulfur_world_add_body(world, plan, above, &crate));
    sulfur_blueprint_destroy(plan);
    for (int tick = 0; tick <= 1000; ++tick) {
        if (tick % 250 == 0) {
            SulfurVec centre;
            must(sulfur_body_centre_of_mass(world, crate, &centre));
            printf("%.1f s: %.2f m\n", tick / 500.0, centre.y);
        }
        must(sulfur_world_step(world));
    }
    sulfur_world_destroy(world);
    return 0;
}
