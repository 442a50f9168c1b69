#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace atlax {

/// All functions here may be called from any thread at any time, and never throw except where said:
/// a log must never be the reason of a failure. The log is one per process; it owns its file.

enum class LogLevel { Debug, Info, Warning, Error };

/// Writes one line with time and level to standard error, to the log file where there is one, and
/// into the memory of last lines. A line that cannot be written (a full disk) is lost silently
/// there and still goes to the others.
void log(LogLevel level, std::string_view line) noexcept;

/// Lines below this level are dropped; Info at the start of a program.
void setLogLevel(LogLevel level) noexcept;

struct LogFile {
    std::filesystem::path file;        ///< missing folders are made
    std::size_t maxBytes = 1'000'000;  ///< beyond which a new one is begun, 1,000 or more
    int keep = 3;  ///< older ones, named "<stem>.1.<extension>" and so on; 1..20
};

/// From now on also writes to a file, which is flushed after each warning and error; instead of the
/// one before. Throws Error when it cannot be opened; the log is then as before.
void logToFile(const LogFile& options);
/// Ends that, and closes the file.
void stopLogFile() noexcept;
/// Whether lines still go to standard error, as they do at first.
void setLogToConsole(bool on) noexcept;

/// How many of the last lines are kept in memory, and how much of each, bytes.
inline constexpr std::size_t recentLogLines = 128;
inline constexpr std::size_t recentLogBytes = 256;

/// The last lines, oldest first, also those written before a file was opened.
std::vector<std::string> recentLog();

}  // namespace atlax
