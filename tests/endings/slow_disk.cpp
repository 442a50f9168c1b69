// Preloaded into a program, it makes flushing and renaming a file take SLOW_DISK milliseconds, so
// that a signal finds the program while it writes. The flush is a wait only: what the real one
// takes depends on what else the machine does.
#include <dlfcn.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace {

void waitForTheDisk() {
    const char* const text = std::getenv("SLOW_DISK");
    std::this_thread::sleep_for(std::chrono::milliseconds(text == nullptr ? 0 : std::atoi(text)));
}

}  // namespace

extern "C" int fsync(int /*descriptor*/) {
    waitForTheDisk();
    return 0;
}

extern "C" int rename(const char* from, const char* to) noexcept {
    waitForTheDisk();
    using Rename = int(const char*, const char*);
    return reinterpret_cast<Rename*>(::dlsym(RTLD_NEXT, "rename"))(from, to);
}
