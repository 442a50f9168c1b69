#pragma once

#include <string>

namespace atlax {

/// What a program leaves behind for whoever looks for a fault: from now on the log also goes to
/// "<name>.log" in stateFolder(name), and crash reports to "crashes" there (see log.hpp and
/// crash_report.hpp, which own them). The first line names program and version.
///
/// Main thread, once, before the program's window opens. Never throws: where nothing can be written
/// (a read-only home, a full disk), the log says so on standard error, and the program goes on.
void keepRecords(const std::string& name, const std::string& version) noexcept;

}  // namespace atlax
