#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <atlax/log.hpp>

namespace atlax {

namespace {

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

/// Standard error, never standard output, which belongs to what a program prints.
spdlog::logger& logger() {
    static const auto instance = [] {
        auto made = std::make_shared<spdlog::logger>(
            "atlax", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        made->set_pattern("%H:%M:%S.%e %^%l%$: %v");
        return made;
    }();
    return *instance;
}

}  // namespace

void log(LogLevel level, std::string_view line) noexcept {
    try {
        logger().log(toSpdlog(level), spdlog::string_view_t(line.data(), line.size()));
    } catch (...) {  // NOLINT: a log must never be the reason of a failure
    }
}

void setLogLevel(LogLevel level) noexcept {
    try {
        logger().set_level(toSpdlog(level));
    } catch (...) {  // NOLINT: as above
    }
}

}  // namespace atlax
