#include "chamber_app.hpp"

#include <wx/image.h>
#include <wx/log.h>
#include <wx/settings.h>

#include <atlax/log.hpp>

#include "../view/palette.hpp"
#include "main_frame.hpp"
#include "script.hpp"

namespace sulfurchamber {

ChamberApp::ChamberApp(Workbench& bench, const Options& options)
    : bench_(bench), options_(options) {}
ChamberApp::~ChamberApp() = default;

ChamberApp& chamberApp() {
    return static_cast<ChamberApp&>(*wxTheApp);
}

bool ChamberApp::OnInit() {
    SetAppName("sulfurchamber");
    SetAppDisplayName("SulfurChamber");
    wxInitAllImageHandlers();
    delete wxLog::SetActiveTarget(new wxLogStderr);
    if (!wxSystemSettings::GetAppearance().IsUsingDarkBackground()) palette::choose(palette::light);
    try {
        auto* frame = new MainFrame(bench_, options_);
        if (options_.unattended()) script_ = std::make_unique<Script>(*frame, options_);
        frame->Show();
        // After the first layout, in which GTK gives the focus to a field.
        frame->CallAfter([frame] { frame->canvas().SetFocus(); });
        if (options_.play) frame->perform("play");
    } catch (const std::exception& error) {
        atlax::log(atlax::LogLevel::Error, error.what());
        return false;
    }
    return true;
}

int ChamberApp::OnRun() {
    const int code = wxApp::OnRun();
    return exitCode_ != 0 ? exitCode_ : code;
}

int ChamberApp::FilterEvent(wxEvent& event) {
    const bool byUser = event.GetEventCategory() == wxEVT_CATEGORY_USER_INPUT;
    auto* const frame = byUser ? dynamic_cast<MainFrame*>(GetTopWindow()) : nullptr;
    if (frame == nullptr) return Event_Skip;
    frame->canvas().stir();  // menus and panels may change what is seen
    if (event.GetEventType() == wxEVT_LEFT_DOWN) frame->leaveKeys();
    return Event_Skip;
}

bool ChamberApp::OnExceptionInMainLoop() {
    try {
        throw;
    } catch (const std::exception& error) {
        atlax::log(atlax::LogLevel::Error, error.what());
    } catch (...) {
        atlax::log(atlax::LogLevel::Error, "an unknown error ended the program");
    }
    exitCode_ = 1;
    return false;
}

void ChamberApp::OnAssertFailure(const wxChar* file, int line, const wxChar* function,
                                 const wxChar* condition, const wxChar* message) {
    const wxString text = wxString::Format("wxWidgets: %s (%s, %s:%d) %s", condition, function,
                                           file, line, message == nullptr ? wxS("") : message);
    atlax::log(atlax::LogLevel::Warning, text.utf8_string());
}

}  // namespace sulfurchamber
