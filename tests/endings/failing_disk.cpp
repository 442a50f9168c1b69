// Preloaded into a program, it makes the FAIL_AT-th thing that the program does to files below the
// folder FAIL_BELOW fail as a full disk does: making, writing, flushing, renaming or linking one.
// Then the file FAIL_BELOW/failed tells what it was.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

std::string folder() {
    const char* const below = std::getenv("FAIL_BELOW");
    return below == nullptr ? "/nowhere/" : std::string(below) + '/';
}

bool isBelow(const char* path) {
    char whole[PATH_MAX];
    if (path[0] == '/') return std::strncmp(path, folder().c_str(), folder().size()) == 0;
    return ::getcwd(whole, sizeof whole) != nullptr &&
           (std::string(whole) + '/').compare(0, folder().size(), folder()) == 0;
}

/// What is no regular file lies nowhere.
std::string nameOf(int descriptor) {
    struct stat info {};
    char path[PATH_MAX] = {};
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const bool isFile = ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) &&
                        ::readlink(link.c_str(), path, sizeof path - 1) > 0;
    return isFile ? path : "/";
}

/// Whether this one fails.
bool fails(const char* what, const std::string& name) {
    if (!isBelow(name.c_str())) return false;
    static std::atomic<int> count{0};
    const char* const at = std::getenv("FAIL_AT");
    if (at == nullptr || ++count != std::atoi(at)) return false;
    const int told = next<int(const char*, int, ...)>("open")((folder() + "failed").c_str(),
                                                              O_CREAT | O_WRONLY, 0600);
    if (told >= 0) {
        const std::string text = std::string(what) + ' ' + name;
        next<ssize_t(int, const void*, size_t)>("write")(told, text.data(), text.size());
        ::close(told);
    }
    errno = ENOSPC;
    return true;
}

}  // namespace

extern "C" {

int mkostemp(char* name, int flags) {
    if (fails("making", name)) return -1;
    return next<int(char*, int)>("mkostemp")(name, flags);
}

FILE* fopen64(const char* name, const char* mode) {
    if (mode[0] != 'r' && fails("making", name)) return nullptr;
    return next<FILE*(const char*, const char*)>("fopen64")(name, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    if (fails("writing", nameOf(descriptor))) return -1;
    return next<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    if (fails("writing", nameOf(descriptor))) return -1;
    return next<ssize_t(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

int fsync(int descriptor) {
    if (fails("flushing", nameOf(descriptor))) return -1;
    return next<int(int)>("fsync")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
    if (fails("renaming", to)) return -1;
    return next<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) noexcept {
    if (fails("linking", to)) return -1;
    return next<int(const char*, const char*)>("link")(from, to);
}

}  // extern "C"
