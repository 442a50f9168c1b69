#include <atlax/records.hpp>

#include <atlax/crash_report.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <exception>

namespace atlax {

namespace {

/// What fails is said, and what follows is tried all the same.
template <class Body>
void attempt(const Body& body) noexcept {
    try {
        body();
    } catch (const std::exception& error) {
        log(LogLevel::Warning, error.what());
    }
}

}  // namespace

void keepRecords(const std::string& name, const std::string& version) noexcept {
    attempt([&] {
        const auto folder = stateFolder(name);
        attempt([&] { logToFile({.file = folder / (name + ".log")}); });
        attempt([&] { installCrashReport({name, version, folder / "crashes"}); });
        log(LogLevel::Info, name + " " + version);
    });
}

}  // namespace atlax
