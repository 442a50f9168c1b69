#include <atlax/application.hpp>
#include <atlax/backend.hpp>

#include "sdl_platform.hpp"

namespace atlax {

int run(Application& application, const WindowOptions& options) {
    if (options.offscreen) return runOffscreen(application, options);
    return guarded([&] { return sdl::SdlPlatform(application, options).loop(); });
}

}  // namespace atlax
