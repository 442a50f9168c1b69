#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atlax/crash_report.hpp>
#include <atlax/error.hpp>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <typeinfo>
#include <vector>

#include "log_ring.hpp"

namespace atlax {

namespace fs = std::filesystem;

namespace {

constexpr std::array fatalSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Everything that a signal handler needs, in static memory, written before the handlers are
/// installed.
struct Report {
    std::array<char, 4096> file{};
    std::array<char, 128> title{};
    std::array<struct sigaction, fatalSignals.size()> before{};
    std::array<char, 64 * 1024> stack{};
    std::terminate_handler terminateBefore = nullptr;
    std::atomic<bool> written{false};
    // A hash and its tick belong together: odd while they are being changed.
    std::atomic<std::uint64_t> sequence{0};
    std::atomic<std::uint64_t> tick{0};
    std::atomic<std::uint64_t> hash{0};
    bool installed = false;
};

constinit Report report;

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

/// Writes text and numbers to a descriptor with nothing but write(2).
class SafeWriter {
public:
    explicit SafeWriter(int descriptor) : descriptor_(descriptor) {}

    void text(const char* text, std::size_t length) const {
        while (length > 0) {
            const auto done = ::write(descriptor_, text, length);
            if (done < 0 && errno == EINTR) continue;
            if (done <= 0) return;
            text += done;
            length -= static_cast<std::size_t>(done);
        }
    }
    void text(const char* c) const { text(c, std::strlen(c)); }

    void number(std::uint64_t value, unsigned base, std::size_t digits = 1) const {
        std::array<char, 24> out{};
        std::size_t at = out.size();
        while (value > 0 || out.size() - at < digits) {
            out[--at] = "0123456789abcdef"[value % base];
            value /= base;
        }
        text(out.data() + at, out.size() - at);
    }

private:
    int descriptor_;
};

const char* signalName(int number) {
    switch (number) {
        case SIGSEGV:
            return "SIGSEGV (invalid memory)";
        case SIGBUS:
            return "SIGBUS (invalid memory)";
        case SIGFPE:
            return "SIGFPE (invalid arithmetic)";
        case SIGILL:
            return "SIGILL (invalid instruction)";
        case SIGABRT:
            return "SIGABRT (the program gave up)";
        default:
            return "an unknown signal";
    }
}

void writeState(const SafeWriter& out) {
    constexpr int attempts = 1000;
    for (int i = 0; i < attempts; ++i) {
        const auto before = report.sequence.load(std::memory_order_acquire);
        const auto tick = report.tick.load(std::memory_order_relaxed);
        const auto hash = report.hash.load(std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (before % 2 != 0 || report.sequence.load(std::memory_order_relaxed) != before) continue;
        if (before == 0) break;
        out.text("state: hash ");
        out.number(hash, 16, 16);
        out.text(" at tick ");
        out.number(tick, 10);
        out.text("\n");
        return;
    }
    out.text("state: unknown\n");
}

/// Async-signal-safe. The first thread that comes here writes; `what` names the reason.
void writeReport(const char* what, const char* detail) noexcept {
    if (report.written.exchange(true)) return;
    const int file =
        ::open(report.file.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) return;
    const SafeWriter out(file);
    out.text(report.title.data());
    out.text("ended by: ");
    out.text(what);
    if (*detail != '\0') {
        out.text(": ");
        out.text(detail);
    }
    out.text("\n");
    writeState(out);
    out.text("last lines of the log:\n");
    logRing().forEach([&](const char* text, std::size_t length) {
        out.text(text, length);
        out.text("\n");
    });
    ::fsync(file);
    ::close(file);
}

/// Gives the signal back to whoever had it: returning runs the faulting instruction again, and a
/// signal that was sent is sent again.
void onSignal(int number, siginfo_t* info, void*) {
    const int savedErrno = errno;
    writeReport(signalName(number), "");
    for (std::size_t i = 0; i < fatalSignals.size(); ++i)
        if (fatalSignals[i] == number) ::sigaction(number, &report.before[i], nullptr);
    const bool sent = info == nullptr || info->si_code <= 0;
    if (sent || number == SIGABRT) ::raise(number);
    errno = savedErrno;
}

[[noreturn]] void onTerminate() {
    if (const std::exception_ptr current = std::current_exception()) {
        try {
            std::rethrow_exception(current);
        } catch (const std::exception& error) {
            writeReport("an exception that nobody caught", error.what());
        } catch (...) {
            writeReport("an exception that nobody caught", "of an unknown type");
        }
    } else {
        writeReport("std::terminate", "");
    }
    if (report.terminateBefore != nullptr) report.terminateBefore();
    std::abort();
}

void installHandlers() {
    stack_t stack{};
    stack.ss_sp = report.stack.data();
    stack.ss_size = report.stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = onSignal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    ::sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < fatalSignals.size(); ++i)
        ::sigaction(fatalSignals[i], &action, &report.before[i]);
    report.terminateBefore = std::set_terminate(onTerminate);
    report.installed = true;
}

void removeOldReports(const fs::path& folder, std::size_t keep) {
    std::vector<fs::path> reports;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("crash-") && name.ends_with(".txt")) reports.push_back(entry.path());
    }
    // The time in their names sorts them.
    std::sort(reports.begin(), reports.end());
    for (std::size_t i = 0; i + keep < reports.size(); ++i) fs::remove(reports[i], failed);
}

std::string reportName() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    std::array<char, 32> time{};
    const auto length = std::strftime(time.data(), time.size(), "%Y%m%d-%H%M%S", &utc);
    return "crash-" + std::string(time.data(), length) + "-" + std::to_string(::getpid()) + ".txt";
}

template <std::size_t size>
void store(std::array<char, size>& to, const std::string& text) {
    const auto length = std::min(text.size(), size - 1);
    std::memcpy(to.data(), text.data(), length);
    to[length] = '\0';
}

}  // namespace

void installCrashReport(const CrashReportOptions& options) {
    if (options.keep < 1 || options.keep > 100)
        throw Error("the number of crash reports to keep must be 1 to 100");
    std::error_code failed;
    fs::create_directories(options.folder, failed);
    if (failed)
        throw Error(options.folder.string() +
                    ": the folder for crash reports cannot be made: " + failed.message());
    const std::string file = (fs::absolute(options.folder) / reportName()).string();
    if (file.size() >= report.file.size())
        throw Error(options.folder.string() + ": this path is too long for crash reports");
    removeOldReports(options.folder, static_cast<std::size_t>(options.keep));
    logRing();  // its first use must not be in a signal
    store(report.file, file);
    store(report.title, options.application + " " + options.version + "\n");
    if (!report.installed) installHandlers();
}

void setCrashState(std::uint64_t tick, std::uint64_t hash) noexcept {
    // Whoever finds it being changed leaves: waiting would not be safe in a signal.
    auto sequence = report.sequence.load(std::memory_order_relaxed);
    if (sequence % 2 != 0 ||
        !report.sequence.compare_exchange_strong(sequence, sequence + 1, std::memory_order_acquire))
        return;
    std::atomic_thread_fence(std::memory_order_release);
    report.tick.store(tick, std::memory_order_relaxed);
    report.hash.store(hash, std::memory_order_relaxed);
    report.sequence.store(sequence + 2, std::memory_order_release);
}

fs::path crashReportFile() {
    return report.installed ? fs::path(report.file.data()) : fs::path();
}

}  // namespace atlax
