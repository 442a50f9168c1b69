// Writing so that a crash, a signal or a full disk leaves either the old file or the new one,
// whole.
//
// The platform layer, the reader of scenes and the laboratory know nothing of each other, but write
// their files alike. So this is a header, which none of them installs.
#pragma once

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace files {

namespace fs = std::filesystem;

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

/// A file that could not be written. What was there before is as it was.
class NotWritten : public std::runtime_error {
public:
    NotWritten(const fs::path& file, const std::string& reason)
        : std::runtime_error(file.string() + ": " + reason) {}
};

/// Whether the content before stays as "<name>.bak".
enum class Backup { none, one };

namespace detail {

[[noreturn]] inline void refuseByErrno(const fs::path& file, const std::string& what) {
    throw NotWritten(file, what + ": " + std::strerror(errno));
}

inline fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Through a link, the file that it points to is the one to replace, whether it is there or not.
inline fs::path behindLinks(const fs::path& file) {
    constexpr int most = 40;  // as Linux has it
    fs::path target = file;
    std::error_code unknown;
    for (int i = 0; i < most && fs::is_symlink(target, unknown); ++i)
        target = target.parent_path() / fs::read_symlink(target, unknown);
    if (fs::is_symlink(target, unknown)) throw NotWritten(file, "is a link that leads nowhere");
    return target;
}

/// Between a file's name and six letters in the names of its new files.
inline constexpr std::string_view newMark = ".new-";

/// Removes what writers of this file have left that were killed: nobody holds its lock any more. By
/// functions of the system, because std::filesystem ends the program where there is no memory.
inline void removeLeftovers(const fs::path& target) {
    const std::string start = target.filename().string() + std::string(newMark);
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir(folderOf(target).c_str()),
                                                     [](DIR* open) { return ::closedir(open); });
    if (!folder) return;
    while (const dirent* const entry = ::readdir(folder.get())) {
        const std::string_view name(entry->d_name);
        if (!name.starts_with(start) || name.size() != start.size() + 6) continue;
        const int within = ::dirfd(folder.get());
        const Descriptor left(::openat(within, entry->d_name, O_RDONLY | O_CLOEXEC | O_NONBLOCK));
        if (left.get() >= 0 && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0)
            ::unlinkat(within, entry->d_name, 0);
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

/// What a new file is to have: as the old one, or as the caller's mask says.
inline mode_t modeFor(const fs::path& target) {
    struct stat before {};
    if (::stat(target.c_str(), &before) == 0) return before.st_mode & 07777;
    const auto mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

/// A new file beside the target, because only there it can be renamed to it. It is locked while its
/// writer lives, and removed again unless it was renamed.
class NewFile {
public:
    explicit NewFile(const fs::path& target) : target_(target) {
        removeLeftovers(target);
        struct stat now {};
        do {  // until nobody has taken it for a leftover before it was locked
            if (number_ >= 0) ::close(number_);
            name_ = target.string() + std::string(newMark) + "XXXXXX";
            number_ = ::mkostemp(name_.data(), O_CLOEXEC);
            if (number_ < 0) refuseByErrno(target, "cannot be written");
            ::flock(number_, LOCK_EX);
        } while (::fstat(number_, &now) == 0 && now.st_nlink == 0);
        ::fchmod(number_, modeFor(target));
    }
    ~NewFile() {
        if (!name_.empty()) ::unlink(name_.c_str());
        if (number_ >= 0) ::close(number_);
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const auto written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) refuseByErrno(target_, "cannot be written");
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
        if (::fsync(number_) != 0) refuseByErrno(target_, "cannot be brought to the disk");
    }
    void becomeTarget() {
        if (::rename(name_.c_str(), target_.c_str()) != 0)
            refuseByErrno(target_, "cannot be replaced");
        name_.clear();
    }

private:
    SignalsWait wait_;
    fs::path target_;
    std::string name_;
    int number_ = -1;
};

/// The old content stays reachable under its name all the time: the backup is a second link to it,
/// put in place by a rename of its own.
inline void keepBackup(const fs::path& file) {
    if (!fs::exists(file)) return;
    const fs::path backup = file.string() + ".bak", fresh = file.string() + ".bak.new";
    ::unlink(fresh.c_str());
    if (::link(file.c_str(), fresh.c_str()) != 0) {
        std::error_code failed;  // a file system without hard links
        fs::copy_file(file, fresh, fs::copy_options::overwrite_existing, failed);
        if (failed) throw NotWritten(backup, "cannot be written: " + failed.message());
    }
    const bool renamed = ::rename(fresh.c_str(), backup.c_str()) == 0;
    const int reason = errno;
    // Where a writer was killed here before, both were names of one file: then a rename does
    // nothing.
    ::unlink(fresh.c_str());
    errno = reason;
    if (!renamed) refuseByErrno(backup, "cannot be written");
}

}  // namespace detail

/// Writes to a new file beside `file`, brings it to the disk and renames it: whatever happens,
/// there is the old content or the new one, never a part. Through a link, the file that it points
/// to is written. What killed writers of this file have left is removed. Throws NotWritten, also
/// for a pipe, a device or a folder.
inline void writeWhole(const fs::path& file, std::string_view bytes, Backup backup = Backup::none) {
    const fs::path target = detail::behindLinks(file);
    std::error_code unknown;
    const auto status = fs::status(target, unknown);
    if (fs::is_directory(status))
        throw NotWritten(file, "is a folder; needed is the name of a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw NotWritten(file, "is no regular file; allowed is a file, or a name that is free");
    {
        detail::NewFile fresh(target);
        fresh.write(bytes);
        if (backup == Backup::one) detail::keepBackup(target);
        fresh.becomeTarget();
    }
    // A rename is on the disk only when its folder is. The file is whole also where that fails.
    const Descriptor folder(
        ::open(detail::folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0) ::fsync(folder.get());
}

}  // namespace files
