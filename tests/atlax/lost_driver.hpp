#pragma once

#include <epoxy/gl.h>

/// While it lives, OpenGL tells of a reset when lose() was called, until a canvas has asked once
/// and its context has been made again. Nothing else changes: software renderers are never reset by
/// themselves. Needs a context that is current.
class LostDriver {
public:
    /// How often the next question is answered by "lost".
    static void lose(int times = 1) {
        // The first call lets libepoxy find the real function, so that it does not put it in later.
        static_cast<void>(glGetGraphicsResetStatus());
        left = times;
        if (epoxy_glGetGraphicsResetStatus != &answer) real = epoxy_glGetGraphicsResetStatus;
        epoxy_glGetGraphicsResetStatus = &answer;
    }
    ~LostDriver() {
        left = 0;
        if (real != nullptr) epoxy_glGetGraphicsResetStatus = real;
    }

private:
    static GLenum EPOXY_CALLSPEC answer() {
        if (left == 0) return GL_NO_ERROR;
        --left;
        return GL_GUILTY_CONTEXT_RESET;
    }

    inline static int left = 0;
    inline static decltype(epoxy_glGetGraphicsResetStatus) real = nullptr;
};
