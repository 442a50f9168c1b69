#include <epoxy/gl.h>
// After gl.h, which it builds on.
#include <epoxy/egl.h>

#include <atlax/error.hpp>
#include <atlax/offscreen.hpp>
#include <vector>

namespace atlax {

struct OffscreenContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

namespace {

[[noreturn]] void fail(const std::string& reason) {
    throw Error("drawing without a window is not possible here: " + reason +
                " (Mesa's software renderer, Debian package libgl1-mesa-dri, would do)");
}

/// Displays stay initialised until the program ends: terminating one would pull it away from every
/// other context of the process.
EGLDisplay openDisplay() {
    EGLDisplay display = EGL_NO_DISPLAY;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY) fail("EGL has no display");
    EGLint major = 0;
    EGLint minor = 0;
    if (eglInitialize(display, &major, &minor) != EGL_TRUE) fail("EGL could not be started");
    return display;
}

/// One that says when the driver is reset, where the driver can.
EGLContext createContext(EGLDisplay display) {
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
    std::vector<EGLint> robust(attributes.begin(), attributes.end() - 1);
    robust.insert(robust.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                 EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE});
    for (const auto& wanted : {robust, attributes}) {
        const EGLContext made =
            eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
        if (made != EGL_NO_CONTEXT) return made;
    }
    return EGL_NO_CONTEXT;
}

}  // namespace

OffscreenContext::OffscreenContext() : handles_(std::make_unique<Handles>()) {
    if (!epoxy_has_egl()) fail("there is no libEGL");
    handles_->display = openDisplay();
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) fail("EGL offers no desktop OpenGL");
    handles_->context = createContext(handles_->display);
    if (handles_->context == EGL_NO_CONTEXT) fail("the driver has no OpenGL 3.3 core");
    makeCurrent();
}

OffscreenContext::~OffscreenContext() {
    if (eglGetCurrentContext() == handles_->context)
        eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(handles_->display, handles_->context);
}

void OffscreenContext::makeCurrent() {
    if (eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context) !=
        EGL_TRUE)
        fail("its context cannot be made current");
}

OffscreenCanvas::OffscreenCanvas(PixelSize size, float scaleFactor)
    : context_(std::make_unique<OffscreenContext>()),
      canvas_(std::make_unique<Canvas>()),
      target_(canvas_->createTarget(size)),
      scaleFactor_(scaleFactor) {}

OffscreenCanvas::~OffscreenCanvas() {
    context_->makeCurrent();
}

Canvas& OffscreenCanvas::begin() {
    context_->makeCurrent();
    canvas_->beginFrame(target_, scaleFactor_);
    canvas_->clear(colors::transparent);
    return *canvas_;
}

void OffscreenCanvas::finish() {
    canvas_->endFrame();
}

Image OffscreenCanvas::image() {
    context_->makeCurrent();
    return canvas_->read(target_);
}

void OffscreenCanvas::resize(PixelSize size) {
    context_->makeCurrent();
    target_ = canvas_->createTarget(size);
}

}  // namespace atlax
