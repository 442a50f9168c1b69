// Reads the screen from the X server itself: wxScreenDC shows what it saw when it was first used.
#include "screen_picture.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <atlax/image.hpp>
#include <memory>
#include <stdexcept>

namespace sulfurchamber {
namespace {

struct CloseDisplay {
    void operator()(Display* display) const { XCloseDisplay(display); }
};
struct DestroyImage {
    void operator()(XImage* image) const { XDestroyImage(image); }
};

// The value of a colour's bits, wherever they are in the pixel.
std::uint8_t channel(unsigned long pixel, unsigned long mask) {
    if (mask == 0) return 0;
    const unsigned long lowest = mask & (~mask + 1);
    return static_cast<std::uint8_t>((pixel & mask) / lowest * 255 / (mask / lowest));
}

}  // namespace

void saveScreen(const wxRect& part, const std::filesystem::path& file) {
    const std::unique_ptr<Display, CloseDisplay> display(XOpenDisplay(nullptr));
    if (!display)
        throw std::runtime_error("pictures of the window need an X server; --picture needs none");
    const int screen = DefaultScreen(display.get());
    const wxRect seen = part.Intersect(
        wxRect(0, 0, DisplayWidth(display.get(), screen), DisplayHeight(display.get(), screen)));
    if (seen.IsEmpty()) throw std::runtime_error("the window is not on the screen");
    const std::unique_ptr<XImage, DestroyImage> picture(XGetImage(
        display.get(), RootWindow(display.get(), screen), seen.x, seen.y,
        static_cast<unsigned>(seen.width), static_cast<unsigned>(seen.height), AllPlanes, ZPixmap));
    if (!picture) throw std::runtime_error("the X server does not show its screen");
    const Visual* visual = DefaultVisual(display.get(), screen);
    atlax::Image image({seen.width, seen.height});
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            const unsigned long pixel = XGetPixel(picture.get(), x, y);
            image.setPixel(x, y,
                           {channel(pixel, visual->red_mask), channel(pixel, visual->green_mask),
                            channel(pixel, visual->blue_mask), 255});
        }
    atlax::savePng(image, file);
}

}  // namespace sulfurchamber
