#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "whole_file.hpp"

namespace atlax {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw Error(file.string() + ": " + reason);
}

[[noreturn]] void failErrno(const fs::path& file, const std::string& what) {
    fail(file, what + ": " + std::strerror(errno));
}

template <class Buffer>
Buffer readWhole(const fs::path& file, std::size_t maxBytes) {
    // Not blocking, so that a pipe in the place of a file cannot hang the program.
    const files::Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (in.get() < 0) failErrno(file, "cannot be opened");
    struct stat info {};
    if (::fstat(in.get(), &info) != 0) failErrno(file, "cannot be read");
    if (!S_ISREG(info.st_mode)) fail(file, "is not a regular file");
    const auto refuseLarge = [&] {
        fail(file, "is larger than the " + std::to_string(maxBytes) + " bytes allowed here");
    };
    const auto size = static_cast<std::size_t>(info.st_size);
    if (size > maxBytes) refuseLarge();
    Buffer out;
    out.resize(size);
    std::size_t done = 0;
    while (done < size) {
        const auto got = ::read(in.get(), out.data() + done, size - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) failErrno(file, "cannot be read");
        if (got == 0) break;  // it became shorter meanwhile
        done += static_cast<std::size_t>(got);
    }
    out.resize(done);
    return out;
}

fs::path xdgFolder(const char* variable, const char* fallback, std::string_view application) {
    const char* value = std::getenv(variable);
    // The specification says that relative paths are to be ignored.
    if (value != nullptr && fs::path(value).is_absolute()) return fs::path(value) / application;
    const char* home = std::getenv("HOME");
    const fs::path base = home != nullptr && *home != '\0' ? fs::path(home) : fs::path("/tmp");
    return base / fallback / application;
}

bool climbsOut(const fs::path& name) {
    if (name.empty() || name.is_absolute()) return true;
    for (const auto& part : name)
        if (part == "..") return true;
    return false;
}

}  // namespace

std::string readFile(const fs::path& file, std::size_t maxBytes) {
    return readWhole<std::string>(file, maxBytes);
}

std::vector<std::byte> readBytes(const fs::path& file, std::size_t maxBytes) {
    return readWhole<std::vector<std::byte>>(file, maxBytes);
}

void writeFileAtomic(const fs::path& file, std::span<const std::byte> bytes, Backup backup) {
    if (file.has_parent_path()) {
        std::error_code failed;
        fs::create_directories(file.parent_path(), failed);
        if (failed) fail(file, "its folder cannot be made: " + failed.message());
    }
    try {
        files::writeWhole(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                          backup == Backup::KeepOne ? files::Backup::one : files::Backup::none);
    } catch (const files::NotWritten& problem) {
        throw Error(problem.what());
    }
}

void writeFileAtomic(const fs::path& file, std::string_view text, Backup backup) {
    writeFileAtomic(file, std::as_bytes(std::span(text.data(), text.size())), backup);
}

fs::path configFolder(std::string_view application) {
    return xdgFolder("XDG_CONFIG_HOME", ".config", application);
}

fs::path dataFolder(std::string_view application) {
    return xdgFolder("XDG_DATA_HOME", ".local/share", application);
}

fs::path cacheFolder(std::string_view application) {
    return xdgFolder("XDG_CACHE_HOME", ".cache", application);
}

fs::path stateFolder(std::string_view application) {
    return xdgFolder("XDG_STATE_HOME", ".local/state", application);
}

fs::path programFolder() {
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    return failed ? fs::path() : program.parent_path();
}

Assets::Assets(const Options& options) {
    if (!options.environmentVariable.empty()) {
        const char* folder = std::getenv(options.environmentVariable.c_str());
        if (folder != nullptr && *folder != '\0') folders_.emplace_back(folder);
    }
    const fs::path program = programFolder();
    if (!program.empty() && !options.application.empty())
        folders_.push_back((program / ".." / "share" / options.application).lexically_normal());
    if (!options.sourceFolder.empty()) folders_.push_back(options.sourceFolder);
}

void Assets::addFolder(const fs::path& folder) {
    folders_.insert(folders_.begin(), folder);
}

bool Assets::exists(std::string_view name) const {
    if (climbsOut(fs::path(name))) return false;
    for (const fs::path& folder : folders_) {
        std::error_code ignored;
        if (fs::is_regular_file(folder / name, ignored)) return true;
    }
    return false;
}

fs::path Assets::find(std::string_view name) const {
    if (climbsOut(fs::path(name)))
        throw Error("\"" + std::string(name) + "\" is not a name below the assets' folders");
    std::string searched;
    for (const fs::path& folder : folders_) {
        std::error_code ignored;
        if (fs::is_regular_file(folder / name, ignored)) return folder / name;
        searched += (searched.empty() ? "" : ", ") + folder.string();
    }
    throw Error("\"" + std::string(name) + "\" was not found; searched: " + searched);
}

}  // namespace atlax
