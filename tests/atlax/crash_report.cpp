#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atlax/crash_report.hpp>
#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <csignal>

#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace atlax;

struct Ended {
    int status = 0;
    std::string report;  ///< empty when none was written
};

/// Runs `body` in a process that has the crash report, and returns what is left of it.
template <class Body>
Ended crash(const fs::path& folder, Body body) {
    const pid_t child = ::fork();
    if (child == 0) {
        const struct rlimit noCore { 0, 0 };
        ::setrlimit(RLIMIT_CORE, &noCore);
        ::close(STDERR_FILENO);
        installCrashReport({.application = "tester", .version = "1.2.3", .folder = folder});
        log(LogLevel::Info, "a line of the log");
        setCrashState(500, 0x0123456789abcdefULL);
        body();
        ::_exit(0);
    }
    Ended out;
    ::waitpid(child, &out.status, 0);
    for (const auto& entry : fs::directory_iterator(folder))
        out.report = readFile(entry.path(), 100'000);
    return out;
}

bool has(const Ended& ended, const std::string& text) {
    return ended.report.find(text) != std::string::npos;
}

void expectComplete(const Ended& ended) {
    EXPECT_EQ(ended.report.find("tester 1.2.3\n"), 0u) << ended.report;
    EXPECT_TRUE(has(ended, "state: hash 0123456789abcdef at tick 500\n")) << ended.report;
    EXPECT_TRUE(has(ended, "info: a line of the log\n")) << ended.report;
    EXPECT_FALSE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0);
}

class CrashSignals : public testing::TestWithParam<int> {};

TEST_P(CrashSignals, areReportedAndStillEndTheProgram) {
    const TemporaryFolder folder;
    const Ended ended = crash(folder.path(), [] { ::raise(GetParam()); });
    expectComplete(ended);
    EXPECT_TRUE(has(ended, "ended by: SIG")) << ended.report;
}

INSTANTIATE_TEST_SUITE_P(All, CrashSignals,
                         testing::Values(SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT));

void fail() {
    throw Error("the reason of it all");
}

TEST(CrashReport, anExceptionIsNamed) {
    const TemporaryFolder folder;
    const Ended ended = crash(folder.path(), [] { []() noexcept { fail(); }(); });
    expectComplete(ended);
    EXPECT_TRUE(has(ended, "nobody caught: the reason of it all")) << ended.report;
}

TEST(CrashReport, aRealFaultIsReported) {
    const TemporaryFolder folder;
    const Ended ended = crash(folder.path(), [] {
        // Without a page behind it; the address is no constant that a compiler could see.
        volatile auto* nowhere = reinterpret_cast<volatile int*>(::getpid() % 2 + 16);
        *nowhere = 1;
    });
    expectComplete(ended);
    EXPECT_TRUE(has(ended, "SIGSEGV")) << ended.report;
}

int endless(int depth) {
    volatile char room[4096];
    if (depth < 0) return 0;
    room[depth % 4096] = 1;
    return endless(depth + 1) + room[0];
}

TEST(CrashReport, anOverflowOfTheStackIsReported) {
    const TemporaryFolder folder;
    const Ended ended = crash(folder.path(), [] { ::_exit(endless(0)); });
    expectComplete(ended);
}

TEST(CrashReport, aProgramThatEndsWellLeavesNone) {
    const TemporaryFolder folder;
    const Ended ended = crash(folder.path(), [] {});
    EXPECT_EQ(ended.report, "");
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(CrashReport, whereItCannotBeWrittenTheProgramEndsAllTheSame) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "gone");
    const Ended ended = crash(folder.path(), [&] {
        installCrashReport({.application = "t", .version = "1", .folder = folder / "gone"});
        fs::remove_all(folder / "gone");
        ::raise(SIGABRT);
    });
    EXPECT_FALSE(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0);
    EXPECT_EQ(ended.report, "");
}

TEST(CrashReport, oldReportsAreRemoved) {
    const TemporaryFolder folder;
    for (int i = 10; i < 20; ++i)
        writeFileAtomic(folder / ("crash-202601" + std::to_string(i) + "-000000-1.txt"), "old");
    writeFileAtomic(folder / "notes.txt", "mine");
    const pid_t child = ::fork();
    if (child == 0) {
        installCrashReport({"t", "1", folder.path(), 3});
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
    EXPECT_TRUE(fs::exists(folder / "crash-20260119-000000-1.txt"));
    EXPECT_TRUE(fs::exists(folder / "notes.txt"));
}

TEST(CrashReport, badOptionsAreRefused) {
    EXPECT_THROW(installCrashReport({"t", "1", "/dev/null/x", 3}), Error);
    EXPECT_THROW(installCrashReport({"t", "1", "/tmp", 0}), Error);
    EXPECT_EQ(crashReportFile(), "");
}

}  // namespace
