#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace atlax {

struct CrashReportOptions {
    std::string application;       ///< name, for the report
    std::string version;           ///< of the application
    std::filesystem::path folder;  ///< where reports go; made at once
    /// Reports beyond so many are removed when the program starts, the oldest first; 1..100.
    int keep = 5;
};

/// From now on std::terminate and the fatal signals (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT)
/// write "crash-<UTC time of start>-<process>.txt" with what happened, the version, the state hash
/// and the last lines of the log. The program then ends as it would have without: handlers that
/// were there before (a sanitizer's) get their turn, and a core is dumped where cores are.
///
/// In a signal only async-signal-safe functions are used, on a stack of their own, so that also an
/// overflow of the main thread's stack is reported; nothing is allocated. If the report cannot be
/// written (a full disk, a read-only home), the program ends all the same.
///
/// Call once, early, in the main thread; again to change the options. One per process; it owns the
/// handlers and never gives them back. Throws Error when the folder cannot be made or its path is
/// too long; reports then go nowhere.
void installCrashReport(const CrashReportOptions& options);

/// Hash of the state of the simulation, and the tick it belongs to, for the report. An application
/// calls it as often as it can afford. Any thread, also signal handlers; no locks.
void setCrashState(std::uint64_t tick, std::uint64_t hash) noexcept;

/// The path that a report of this process would have; empty before installCrashReport. Main thread.
std::filesystem::path crashReportFile();

}  // namespace atlax
