/* Checks of the C interface, written in C99 and run by c_interface_test.cpp. Each returns null, or
   what did not hold. */
#ifndef SULFUR_TESTS_C_CHECKS_H
#define SULFUR_TESTS_C_CHECKS_H

#include <sulfur/c/sulfur.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A world with a stack of crates, a rope with a load, a jelly, a broken wall and more; the same as
   that of c_interface_test.cpp. The handles of its crates are left at `crates`. */
const char* c_make_scene(SulfurWorld** world, SulfurBodyId crates[5]);

const char* c_check_bodies(void);
const char* c_check_blueprint(void);
const char* c_check_angles(void);
const char* c_check_parts(void);
const char* c_check_mechanisms(void);
const char* c_check_queries(void);
const char* c_check_events(void);
const char* c_check_state(void);
const char* c_check_draw(void);
const char* c_check_errors(void);
const char* c_check_threads(void);
const char* c_check_callbacks(void);

#ifdef __cplusplus
}
#endif

#endif
