// What of a failure is left for the caller: a result, and a sentence for people.
#include "call.hpp"

#include <cstdio>
#include <new>
#include <sulfur/math.hpp>
#include <sulfur/version.hpp>

namespace sulfur::c {

namespace {

// No string: to leave a message must not need memory.
thread_local char lastError[1024] = "";

SulfurResult note(SulfurResult result, const char* message) noexcept {
    std::snprintf(lastError, sizeof lastError, "%s", message);
    return result;
}

SulfurResult resultOf(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::notFinite:
            return SULFUR_NOT_FINITE;
        case ErrorCode::outOfRange:
            return SULFUR_OUT_OF_RANGE;
        case ErrorCode::badIndex:
            return SULFUR_BAD_INDEX;
        case ErrorCode::staleHandle:
            return SULFUR_STALE_HANDLE;
        case ErrorCode::degenerate:
            return SULFUR_DEGENERATE;
        case ErrorCode::badSnapshot:
            return SULFUR_BAD_SNAPSHOT;
        case ErrorCode::outOfMemory:
            return SULFUR_TORN;
        case ErrorCode::inCallback:
            return SULFUR_IN_CALLBACK;
    }
    return SULFUR_FAILED;
}

}  // namespace

SulfurResult noteFailure() noexcept {
    try {
        throw;
    } catch (const Error& error) {
        return note(resultOf(error.code()), error.what());
    } catch (const NullPointer& pointer) {
        std::snprintf(lastError, sizeof lastError,
                      "the pointer to %s is null; allowed is one to something", pointer.what);
        return SULFUR_NULL_POINTER;
    } catch (const std::bad_alloc&) {
        return note(SULFUR_NO_MEMORY, "there is no memory for what was asked");
    } catch (const std::exception& error) {
        return note(SULFUR_FAILED, error.what());
    } catch (...) {
        return note(SULFUR_FAILED, "a function of the caller has thrown something");
    }
}

extern "C" {

const char* sulfur_last_error(void) {
    return lastError;
}

const char* sulfur_result_name(SulfurResult result) {
    static constexpr const char* names[] = {
        "ok",           "not finite", "out of range",  "bad index", "stale handle", "degenerate",
        "bad snapshot", "torn",       "in a callback", "no memory", "null pointer", "failed"};
    static_assert(std::size(names) == SULFUR_FAILED + 1);
    return result >= 0 && result <= SULFUR_FAILED ? names[result] : "?";
}

const char* sulfur_version(void) {
    return version();
}

bool sulfur_double_precision(void) {
    return sizeof(Real) == sizeof(double);
}

}  // extern "C"

}  // namespace sulfur::c
