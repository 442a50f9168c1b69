#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atlax/crash_report.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <atlax/records.hpp>
#include <cstdlib>

#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

/// Log and handlers belong to a process: each case has its own. Returns its exit status.
template <class Body>
int inAProcess(const fs::path& state, Body body) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(STDERR_FILENO);
        ::setenv("XDG_STATE_HOME", state.c_str(), 1);
        ::_exit(body());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Records, logAndReportsLieInTheStateFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(inAProcess(folder.path(),
                         [] {
                             keepRecords("tester", "1.2.3");
                             log(LogLevel::Warning, "something odd");
                             return crashReportFile().parent_path() ==
                                            stateFolder("tester") / "crashes"
                                        ? 0
                                        : 1;
                         }),
              0);
    const std::string text = readFile(folder / "tester" / "tester.log", 10'000);
    EXPECT_NE(text.find("tester 1.2.3"), std::string::npos) << text;
    EXPECT_NE(text.find("something odd"), std::string::npos) << text;
    EXPECT_TRUE(fs::is_directory(folder / "tester" / "crashes"));
}

TEST(Records, aPlaceThatCannotBeWrittenStopsNothing) {
    EXPECT_EQ(inAProcess("/proc/no/such/place",
                         [] {
                             keepRecords("tester", "1.2.3");
                             log(LogLevel::Warning, "something odd");
                             const auto lines = recentLog();
                             return lines.size() >= 4 && crashReportFile().empty() ? 0 : 1;
                         }),
              0);
}

}  // namespace
