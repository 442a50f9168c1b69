#pragma once

#include <stdexcept>
#include <string>

namespace atlax {

/// What atlax throws: one clear sentence that says what went wrong and, where it
/// is known, what to do about it. Nothing else is thrown on purpose.
/// Owns its text; any thread.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace atlax
