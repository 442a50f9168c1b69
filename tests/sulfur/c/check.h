/* How the checks are written. */
#ifndef SULFUR_TESTS_C_CHECK_H
#define SULFUR_TESTS_C_CHECK_H

#include <sulfur/c/sulfur.h>

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
/* Ends the function with what does not hold. */
#define CHECK(condition)                                                      \
    do {                                                                      \
        if (!(condition)) return __FILE__ ":" TEXT(__LINE__) ": " #condition; \
    } while (0)
#define OK(call) CHECK((call) == SULFUR_OK)

static inline SulfurVec v(double x, double y) {
    SulfurVec result;
    result.x = x;
    result.y = y;
    return result;
}

static inline SulfurPose at(double x, double y, double angle) {
    SulfurPose result;
    result.position = v(x, y);
    result.angle = angle;
    return result;
}

#endif
