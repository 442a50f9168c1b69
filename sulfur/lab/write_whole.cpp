#include "write_whole.hpp"

#include <csignal>
#include <fstream>
#include <stdexcept>

namespace sulfur::lab {

namespace {

namespace fs = std::filesystem;

/// Signals that end a program wait as long as it lives: else the file that is written would be
/// left.
class SignalsWait {
public:
    SignalsWait() {
        sigset_t ends;
        ::sigemptyset(&ends);
        for (const int number : {SIGHUP, SIGINT, SIGTERM}) ::sigaddset(&ends, number);
        ::pthread_sigmask(SIG_BLOCK, &ends, &before_);
    }
    ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

private:
    sigset_t before_{};
};

}  // namespace

void writeWhole(const fs::path& file, const std::string& text) {
    std::error_code problem, unknown;
    const fs::path target = fs::weakly_canonical(file, problem);
    const auto status = fs::symlink_status(target, unknown);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw std::runtime_error(file.string() +
                                 " is no regular file; allowed is a file, or a name that is free");
    fs::path half = target;
    half += ".new";
    if (!problem) {
        const SignalsWait wait;
        std::ofstream stream(half, std::ios::binary);
        stream << text;
        stream.close();
        if (stream && fs::exists(status)) fs::permissions(half, status.permissions(), problem);
        if (stream && !problem) fs::rename(half, target, problem);
        if (stream && !problem) return;
        fs::remove(half, unknown);
    }
    throw std::runtime_error(file.string() + " cannot be written; choose a place that can");
}

}  // namespace sulfur::lab
