#include <wx/setup.h>

#include <atlax/wx/view.hpp>
#include <cstdlib>

namespace atlax::wx {

void prepareDisplay() {
#if !wxUSE_GLCANVAS_EGL
    setenv("GDK_BACKEND", "x11", 0);
#endif
}

}  // namespace atlax::wx
