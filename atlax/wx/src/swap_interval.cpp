#include "swap_interval.hpp"

#include <epoxy/egl.h>
#include <epoxy/glx.h>

namespace atlax::wx {

void setSwapInterval(bool waitForDisplay) {
    const int interval = waitForDisplay ? 1 : 0;
    if (glXGetCurrentContext() != nullptr) {
        Display* display = glXGetCurrentDisplay();
        if (epoxy_has_glx_extension(display, DefaultScreen(display), "GLX_EXT_swap_control"))
            glXSwapIntervalEXT(display, glXGetCurrentDrawable(), interval);
        else if (epoxy_has_glx_extension(display, DefaultScreen(display), "GLX_MESA_swap_control"))
            glXSwapIntervalMESA(static_cast<unsigned>(interval));
        return;
    }
    if (EGLDisplay display = eglGetCurrentDisplay(); display != EGL_NO_DISPLAY)
        eglSwapInterval(display, interval);
}

}  // namespace atlax::wx
