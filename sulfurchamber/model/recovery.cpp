#include "recovery.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "words.hpp"

namespace sulfurchamber {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& file, const char* ending) {
    return fs::path(file).replace_extension(ending);
}

// Holds it as long as the descriptor is open, so for as long as the process lives.
int lockFile(const fs::path& file) {
    const int handle = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (handle >= 0 && ::flock(handle, LOCK_EX | LOCK_NB) == 0) return handle;
    if (handle >= 0) ::close(handle);
    return -1;
}

void removeAll(const fs::path& file) {
    std::error_code error;
    for (const char* ending : {".json", ".json.bak", ".of", ".of.bak", ".lock"})
        fs::remove(beside(file, ending), error);
}

}  // namespace

Recovery::Recovery(fs::path folder) : folder_(std::move(folder)) {}

Recovery::~Recovery() {
    forget();
}

void Recovery::forget() {
    if (lock_ < 0) return;
    removeAll(file_);
    ::close(lock_);
    lock_ = -1;
    kept_ = 0;
}

std::string Recovery::keep(const Document& document) {
    if (!document.modified()) {
        forget();
        return "";
    }
    if (kept_ == document.state()) return "";
    try {
        if (lock_ < 0) {
            fs::create_directories(folder_);
            for (int n = 1; lock_ < 0 && n < 1000; ++n) {
                file_ = folder_ /
                        ("kept-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".json");
                if (!fs::exists(file_)) lock_ = lockFile(beside(file_, ".lock"));
            }
            if (lock_ < 0) return tr("unsaved work cannot be kept in {}", {folder_.string()});
        }
        sulfur::scene::writeFile(document.file().string(), beside(file_, ".of"));
        sulfur::scene::writeFile(document.text(), file_);
        kept_ = document.state();
        return "";
    } catch (const std::exception& problem) {
        return problem.what();
    }
}

std::vector<Recovery::Left> Recovery::left(const fs::path& folder) {
    std::vector<Left> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const fs::path& kept = entry.path();
        if (kept.extension() != ".json" || !kept.filename().string().starts_with("kept-")) continue;
        const int lock = lockFile(beside(kept, ".lock"));
        if (lock < 0) continue;  // its program runs
        ::close(lock);
        Left one{kept, {}};
        std::ifstream stream(beside(kept, ".of"));
        std::string name;
        if (std::getline(stream, name)) one.of = name;
        found.push_back(std::move(one));
    }
    std::sort(found.begin(), found.end(), [](const Left& a, const Left& b) {
        std::error_code ignored;
        return fs::last_write_time(a.kept, ignored) > fs::last_write_time(b.kept, ignored);
    });
    return found;
}

void Recovery::discard(const Left& left) {
    removeAll(left.kept);
}

}  // namespace sulfurchamber
