#pragma once

#include <string_view>

namespace atlax {

enum class LogLevel { Debug, Info, Warning, Error };

/// Writes one line to standard error with its level. May be called from any thread.
/// Never throws: a log that cannot be written is lost silently.
void log(LogLevel level, std::string_view line) noexcept;

/// Lines below this level are dropped; Info at the start of a program.
void setLogLevel(LogLevel level) noexcept;

}  // namespace atlax
