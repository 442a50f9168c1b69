#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <mutex>

#include "log_ring.hpp"

namespace atlax {

namespace {

constexpr const char* pattern = "%H:%M:%S.%e %^%l%$: %v";
constexpr const char* filePattern = "%Y-%m-%d %H:%M:%S.%e %l: %v";

spdlog::level::level_enum toSpdlog(LogLevel level) {
    switch (level) {
        case LogLevel::Debug:
            return spdlog::level::debug;
        case LogLevel::Info:
            return spdlog::level::info;
        case LogLevel::Warning:
            return spdlog::level::warn;
        case LogLevel::Error:
            break;
    }
    return spdlog::level::err;
}

/// The list of sinks changes while other threads write, which spdlog's own list may not.
class Log {
public:
    Log() : console_(std::make_shared<spdlog::sinks::stderr_color_sink_mt>()) {
        console_->set_pattern(pattern);
    }

    void write(LogLevel level, std::string_view line) {
        std::shared_ptr<spdlog::sinks::sink> file, console;
        {
            const std::scoped_lock lock(mutex_);
            if (level < lowest_) return;
            logRing().add(level, line);
            file = file_;
            if (toConsole_) console = console_;
        }
        const spdlog::details::log_msg message("atlax", toSpdlog(level),
                                               spdlog::string_view_t(line.data(), line.size()));
        for (auto* sink : {console.get(), file.get()}) send(sink, message, level);
    }

    void setLevel(LogLevel level) {
        const std::scoped_lock lock(mutex_);
        lowest_ = level;
    }

    void setFile(std::shared_ptr<spdlog::sinks::sink> file) {
        const std::scoped_lock lock(mutex_);
        file_ = std::move(file);
    }

    void setConsole(bool on) {
        const std::scoped_lock lock(mutex_);
        toConsole_ = on;
    }

private:
    /// One sink that fails must not keep the line from the next.
    static void send(spdlog::sinks::sink* sink, const spdlog::details::log_msg& message,
                     LogLevel level) noexcept {
        if (sink == nullptr) return;
        try {
            sink->log(message);
            if (level >= LogLevel::Warning) sink->flush();
        } catch (...) {  // NOLINT: a log must never be the reason of a failure
        }
    }

    std::mutex mutex_;
    LogLevel lowest_ = LogLevel::Info;
    bool toConsole_ = true;
    std::shared_ptr<spdlog::sinks::sink> console_;
    std::shared_ptr<spdlog::sinks::sink> file_;
};

/// Standard error, never standard output, which belongs to what a program prints. It lives on to
/// the last destructor that may write a line.
Log& theLog() {
    static Log* const instance = new Log;
    return *instance;
}

}  // namespace

void log(LogLevel level, std::string_view line) noexcept {
    try {
        theLog().write(level, line);
    } catch (...) {  // NOLINT: a log must never be the reason of a failure
    }
}

void setLogLevel(LogLevel level) noexcept {
    try {
        theLog().setLevel(level);
    } catch (...) {  // NOLINT: as above
    }
}

void logToFile(const LogFile& options) {
    if (options.maxBytes < 1000 || options.keep < 1 || options.keep > 20)
        throw Error(options.file.string() +
                    ": a log file must be allowed 1000 bytes or more, and 1 to 20 older ones");
    try {
        auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(
            options.file.string(), options.maxBytes, static_cast<std::size_t>(options.keep));
        sink->set_pattern(filePattern);
        theLog().setFile(std::move(sink));
    } catch (const spdlog::spdlog_ex& error) {
        throw Error(options.file.string() + ": the log cannot be written there: " + error.what());
    }
}

void stopLogFile() noexcept {
    try {
        theLog().setFile(nullptr);
    } catch (...) {  // NOLINT: as above
    }
}

void setLogToConsole(bool on) noexcept {
    try {
        theLog().setConsole(on);
    } catch (...) {  // NOLINT: as above
    }
}

std::vector<std::string> recentLog() {
    std::vector<std::string> out;
    out.reserve(recentLogLines);
    logRing().forEach(
        [&](const char* text, std::size_t length) { out.emplace_back(text, length); });
    return out;
}

}  // namespace atlax
