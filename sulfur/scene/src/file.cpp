// Writing so that a crash or a full disk leaves either the old file or the new one, whole.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sulfur/scene/file.hpp>
#include <system_error>

namespace sulfur::scene {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const char* what, int reason) {
    throw WriteError(file.string() + ": " + what + ": " + std::strerror(reason) +
                     "; nothing was changed, choose another place or make room");
}

/// Through a link, the file that it points to is the one to replace, whether it is there or not.
fs::path behindLinks(const fs::path& file) {
    constexpr int most = 40;  // as Linux has it
    fs::path target = file;
    std::error_code problem;
    for (int i = 0; i < most && fs::is_symlink(target, problem); ++i)
        target = target.parent_path() / fs::read_symlink(target, problem);
    if (fs::is_symlink(target, problem))
        throw WriteError(file.string() + ": is a link that leads nowhere; choose another place");
    return target;
}

/// Between a file's name and six letters in the names of its new files.
constexpr const char* newMark = ".new-";

/// Removes what writers of this file have left that were killed: nobody holds its lock any more.
void removeLeftovers(const fs::path& target) {
    const std::string start = target.filename().string() + newMark;
    std::error_code ignored;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(start) || name.size() != start.size() + 6) continue;
        const int left = ::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (left < 0) continue;
        if (::flock(left, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
        ::close(left);
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

/// A new file, locked while its writer lives, that vanishes unless it is kept.
class NewFile {
public:
    /// Beside `target`, because only there it can be renamed to it.
    explicit NewFile(const fs::path& target) : target_(target) {
        removeLeftovers(target);
        struct stat now {};
        do {  // until nobody has taken it for a leftover before it was locked
            if (descriptor_ >= 0) ::close(descriptor_);
            path_ = target.string() + newMark + "XXXXXX";
            descriptor_ = ::mkostemp(path_.data(), O_CLOEXEC);
            if (descriptor_ < 0) refuse(target_, "cannot be written", errno);
            ::flock(descriptor_, LOCK_EX);
        } while (::fstat(descriptor_, &now) == 0 && now.st_nlink == 0);
        struct stat before {};
        const bool there = ::stat(target_.c_str(), &before) == 0;
        const auto mask = ::umask(0);
        ::umask(mask);
        ::fchmod(descriptor_, there ? before.st_mode & 07777 : 0666 & ~mask);
    }
    ~NewFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(const std::string& text) {
        std::size_t done = 0;
        while (done < text.size()) {
            const auto count = ::write(descriptor_, text.data() + done, text.size() - done);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) refuse(target_, "cannot be written", errno);
            done += static_cast<std::size_t>(count);
        }
        if (::fsync(descriptor_) != 0) refuse(target_, "cannot be brought to the disk", errno);
    }

    void keepAs(const fs::path& name) {
        if (::rename(path_.c_str(), name.c_str()) != 0)
            refuse(target_, "cannot be replaced", errno);
        path_.clear();
    }

private:
    SignalsWait wait_;
    fs::path target_;
    std::string path_;
    int descriptor_ = -1;
};

/// A rename is on the disk only when its folder is.
void syncFolder(const fs::path& file) {
    const auto folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

void keepBackup(const fs::path& file) {
    if (!fs::is_regular_file(file)) return;
    const fs::path backup = file.string() + ".bak";
    const fs::path half = file.string() + ".bak.new";
    std::error_code problem;
    fs::copy_file(file, half, fs::copy_options::overwrite_existing, problem);
    if (!problem) fs::rename(half, backup, problem);
    if (!problem) return;
    std::error_code ignored;
    fs::remove(half, ignored);
    throw WriteError(file.string() + ": no backup can be made: " + problem.message() +
                     "; nothing was changed, choose another place or make room");
}

}  // namespace

void writeFile(const std::string& text, const fs::path& file) {
    const fs::path target = behindLinks(file);
    std::error_code problem;
    const auto status = fs::status(target, problem);
    if (fs::is_directory(status))
        throw WriteError(file.string() + ": is a folder; needed is the name of a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw WriteError(file.string() +
                         ": is no regular file; allowed is a file, or a name that is free");
    NewFile fresh(target);
    fresh.write(text);
    keepBackup(target);
    fresh.keepAs(target);
    syncFolder(target);
}

void write(const Scene& scene, const fs::path& file) {
    const std::string text = format(scene);
    parse(text, file.string());
    writeFile(text, file);
}

void writeBlueprint(const Prefab& prefab, const fs::path& file) {
    const std::string text = format(prefab);
    parseBlueprint(text, file.string());
    writeFile(text, file);
}

}  // namespace sulfur::scene
