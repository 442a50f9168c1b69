#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atlax/error.hpp>
#include <atlax/files.hpp>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace atlax {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw Error(file.string() + ": " + reason);
}

[[noreturn]] void failErrno(const fs::path& file, const std::string& what) {
    fail(file, what + ": " + std::strerror(errno));
}

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return number_; }

private:
    int number_;
};

template <class Buffer>
Buffer readWhole(const fs::path& file, std::size_t maxBytes) {
    // Not blocking, so that a pipe in the place of a file cannot hang the program.
    const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
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

void writeAll(const Descriptor& out, const fs::path& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto written = ::write(out.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) failErrno(file, "cannot be written");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    if (::fsync(out.get()) != 0) failErrno(file, "cannot be flushed to the disk");
}

/// Between a file's name and six letters in the names of its new files.
constexpr std::string_view newMark = ".new-";

/// Through a link, the file that it points to is the one to replace, whether it is there or not.
fs::path behindLinks(const fs::path& file) {
    constexpr int most = 40;  // as Linux has it
    fs::path target = file;
    std::error_code unknown;
    for (int i = 0; i < most && fs::is_symlink(target, unknown); ++i)
        target = target.parent_path() / fs::read_symlink(target, unknown);
    if (fs::is_symlink(target, unknown)) fail(file, "is a link that leads nowhere");
    return target;
}

/// Removes what writers of this file have left that were killed: nobody holds its lock any more.
void removeLeftovers(const fs::path& target) {
    const std::string start = target.filename().string() + std::string(newMark);
    std::error_code ignored;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(start) || name.size() != start.size() + 6) continue;
        const Descriptor left(::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
        if (left.get() >= 0 && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0)
            ::unlink(entry.path().c_str());
    }
}

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

/// A new file beside the target, locked while its writer lives, removed again unless it was
/// renamed.
class NewFile {
public:
    explicit NewFile(const fs::path& target) {
        removeLeftovers(target);
        struct stat info {};
        do {  // until nobody has taken it for a leftover before it was locked
            if (number_ >= 0) ::close(number_);
            name_ = target.string() + std::string(newMark) + "XXXXXX";
            number_ = ::mkostemp(name_.data(), O_CLOEXEC);
            if (number_ < 0) failErrno(target, "cannot be written");
            ::flock(number_, LOCK_EX);
        } while (::fstat(number_, &info) == 0 && info.st_nlink == 0);
        ::fchmod(number_, 0644);
    }
    ~NewFile() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    int descriptor() const { return number_; }
    void renameTo(const fs::path& target) {
        if (::rename(name_.c_str(), target.c_str()) != 0) failErrno(target, "cannot be replaced");
        name_.clear();
    }

private:
    SignalsWait wait_;
    std::string name_;
    int number_ = -1;
};

/// The old content stays reachable under its name all the time: the backup is a second link to it,
/// put in place by a rename of its own.
void keepBackup(const fs::path& file) {
    if (!fs::exists(file)) return;
    const fs::path backup = file.string() + ".bak";
    const fs::path fresh = file.string() + ".bak.new";
    ::unlink(fresh.c_str());
    if (::link(file.c_str(), fresh.c_str()) != 0) {
        std::error_code failed;  // a file system without hard links
        fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, failed);
        if (failed) fail(backup, "cannot be written: " + failed.message());
    }
    if (::rename(fresh.c_str(), backup.c_str()) != 0) {
        ::unlink(fresh.c_str());
        failErrno(backup, "cannot be written");
    }
    // Where a writer was killed here before, both were names of one file: then a rename does
    // nothing.
    ::unlink(fresh.c_str());
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
    const fs::path target = behindLinks(file);
    std::error_code unknown;
    const auto status = fs::status(target, unknown);
    if (fs::is_directory(status)) fail(file, "is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(file, "is no regular file; allowed is a file, or a name that is free");
    NewFile fresh(target);
    const Descriptor out(fresh.descriptor());  // locked until the file has its name
    writeAll(out, target, bytes);
    if (backup == Backup::KeepOne) keepBackup(target);
    fresh.renameTo(target);
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
