// Drops a file on a window as a file manager does, by the XDND protocol (version 5) of X11.
//   drop_file WINDOW X Y FILE     a place in pixels of the window
// Ends with 0 when the window has taken the file.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace {

class Dropper {
public:
    Dropper(Display* display, Window target, std::string uri)
        : display_(display), target_(target), uri_(std::move(uri)) {
        source_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
    }

    bool drop(int x, int y) {
        int rootX = 0, rootY = 0;
        Window child = 0;
        XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), x, y, &rootX, &rootY,
                              &child);
        constexpr long version = 5;
        send("XdndEnter", version << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
        const long place = (static_cast<long>(rootX) << 16) | rootY;
        const long copy = static_cast<long>(atom("XdndActionCopy"));
        send("XdndPosition", 0, place, CurrentTime, copy);
        if (!answer("XdndStatus") || !accepted_) return false;
        // A target may say yes only to the second position, when it has seen what is dropped.
        send("XdndDrop", 0, CurrentTime, 0, 0);
        return answer("XdndFinished");
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    void send(const char* type, long a, long b, long c, long d) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(source_);
        event.xclient.data.l[1] = a;
        event.xclient.data.l[2] = b;
        event.xclient.data.l[3] = c;
        event.xclient.data.l[4] = d;
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    // Waits five seconds for a message, and hands out what is dropped to who asks.
    bool answer(const char* type) {
        const Atom wanted = atom(type);
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        while (std::chrono::steady_clock::now() < end) {
            if (XPending(display_) == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) handOut(event.xselectionrequest);
            if (event.type != ClientMessage || event.xclient.message_type != wanted) continue;
            accepted_ = (event.xclient.data.l[1] & 1) != 0;
            return true;
        }
        return false;
    }

    void handOut(const XSelectionRequestEvent& request) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(uri_.data());
        XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                        PropModeReplace, bytes, static_cast<int>(uri_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Window target_;
    Window source_ = 0;
    std::string uri_;
    bool accepted_ = false;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: drop_file WINDOW X Y FILE\n");
        return 2;
    }
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) {
        std::fprintf(stderr, "there is no X display\n");
        return 2;
    }
    const std::string uri = "file://" + std::filesystem::absolute(argv[4]).string() + "\r\n";
    const Window target = std::strtoul(argv[1], nullptr, 0);
    const bool taken = Dropper(display, target, uri).drop(std::atoi(argv[2]), std::atoi(argv[3]));
    XCloseDisplay(display);
    if (!taken) std::fprintf(stderr, "the window did not take the file\n");
    return taken ? 0 : 1;
}
