// atlax::run on wxWidgets: one frame that holds one View.
#include <wx/app.h>
#include <wx/frame.h>
#include <wx/init.h>
#include <wx/log.h>

#include <algorithm>
#include <atlax/backend.hpp>
#include <atlax/error.hpp>
#include <atlax/log.hpp>
#include <atlax/wx/view.hpp>

namespace atlax {
namespace {

// The application of wxWidgets: a failed assertion goes to the log and asks nobody.
class RunApp final : public wxApp {
public:
    bool OnInit() override { return true; }
    void OnAssertFailure(const wxChar* file, int line, const wxChar* function,
                         const wxChar* condition, const wxChar* message) override {
        log(LogLevel::Warning, wxString::Format("wxWidgets: %s (%s, %s:%d) %s", condition, function,
                                                file, line, message == nullptr ? wxS("") : message)
                                   .utf8_string());
    }
};

class RunFrame final : public wxFrame {
public:
    RunFrame(Application& application, const WindowOptions& options, int& exitCode,
             std::string& error)
        : wxFrame(nullptr, wxID_ANY, wxString::FromUTF8(options.title), wxDefaultPosition,
                  wxDefaultSize, style(options)) {
        view_ = new wx::View(this, application, options);
        view_->setOnEnd([&, this](int code, const std::string& sentence) {
            exitCode = code;
            error = sentence;
            Destroy();
        });
        SetClientSize(std::clamp(options.size.width, 64, 8192),
                      std::clamp(options.size.height, 64, 8192));
        Bind(wxEVT_CLOSE_WINDOW, [this](wxCloseEvent& event) { onClose(event); });
        Show();
        if (options.fullscreen) ShowFullScreen(true);
        view_->SetFocus();
    }

private:
    static long style(const WindowOptions& options) {
        constexpr long fixedSize = wxDEFAULT_FRAME_STYLE & ~(wxRESIZE_BORDER | wxMAXIMIZE_BOX);
        return options.resizable ? wxDEFAULT_FRAME_STYLE : fixedSize;
    }

    void onClose(wxCloseEvent& event) {
        if (!view_->running()) {
            Destroy();
            return;
        }
        // The application is asked, and ends the view if it agrees; the frame goes with it.
        if (event.CanVeto()) event.Veto();
        view_->send(CloseRequested{});
    }

    wx::View* view_ = nullptr;
};

// wxWidgets from start to end.
class Session {
public:
    Session() {
        if (wxTheApp != nullptr)
            throw Error(
                "atlax::run cannot start inside a program that runs wxWidgets already; put an "
                "atlax::wx::View into its frame instead");
        wx::prepareDisplay();
        wxApp::SetInstance(new RunApp);
        if (!wxEntryStart(argc_, arguments_) || !wxTheApp->CallOnInit())
            throw Error(
                "no window can be opened: there is no display (DISPLAY or WAYLAND_DISPLAY is not "
                "set, or refuses); use the offscreen option on machines without one");
        delete wxLog::SetActiveTarget(new wxLogStderr);
    }
    ~Session() { wxEntryCleanup(); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

private:
    int argc_ = 1;
    char name_[6] = "atlax";
    char* arguments_[2] = {name_, nullptr};
};

}  // namespace

int run(Application& application, const WindowOptions& options) {
    if (options.offscreen) return runOffscreen(application, options);
    return guarded([&] {
        int exitCode = 0;
        std::string error;
        {
            const Session session;
            new RunFrame(application, options, exitCode, error);  // destroys itself when closed
            wxTheApp->OnRun();
        }
        if (!error.empty()) throw Error(error);
        return exitCode;
    });
}

}  // namespace atlax
