/// \file
/// How the library refuses nonsense.
#pragma once

#include <stdexcept>
#include <string>

namespace sulfur {

/// What kind of mistake a call contained.
enum class ErrorCode {
    notFinite,    ///< a NaN or an infinity where a finite number is needed
    outOfRange,   ///< a number outside the range that its documentation gives
    badIndex,     ///< an index that points at nothing
    staleHandle,  ///< a handle that is null, or whose thing was removed
    degenerate,   ///< geometry that cannot work, such as a rigid joint of length zero
    badSnapshot,  ///< bytes that are no snapshot, or one of another version or build
    outOfMemory,  ///< a world in the middle of a tick for which there was no memory
    inCallback,   ///< a call that no callback may make; see callbacks.hpp
};

/// Thrown by every public function that is given something it cannot use. The message is one
/// sentence: what is wrong, where, and what is allowed. The world is then unchanged.
class Error : public std::runtime_error {
public:
    /// An error with its message for people.
    Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    /// What kind of mistake it was.
    ErrorCode code() const { return code_; }

private:
    ErrorCode code_;
};

}  // namespace sulfur
