#include "main_frame.hpp"

#include <wx/aboutdlg.h>
#include <wx/app.h>
#include <wx/image.h>
#include <wx/menu.h>
#include <wx/msgdlg.h>
#include <wx/spinctrl.h>
#include <wx/textctrl.h>

#include <array>
#include <atlax/backend.hpp>
#include <atlax/log.hpp>
#include <cctype>

#include "../model/geometry.hpp"
#include "chamber_app.hpp"
#include "icons.hpp"

namespace sulfurchamber {
namespace {

constexpr std::int64_t refreshNs = 100'000'000;  // panels follow ten times a second

}  // namespace

MainFrame::MainFrame(Workbench& bench, const Options& options)
    : wxFrame(nullptr, wxID_ANY, "SulfurChamber"), bench_(bench), options_(options), view_(bench) {
    wxUpdateUIEvent::SetMode(wxUPDATE_UI_PROCESS_SPECIFIED);  // refresh() does it, less often
    SetIcons(wxIconBundle(programIcon().GetIcon(wxSize(64, 64))));
    actions_.reserve(64);
    makeActions();
    makeMenus();
    makeBars();
    makePanels();
    makeStatusBar();
    loadPreferences();
    view_.onFile = [this](const std::filesystem::path& file) {
        if (mayDiscard()) openFile(file);
    };
    view_.onProblem = [this](const std::string& problem) { tell(problem); };
    view_.onFrame = [this] { onFrame(); };
    canvas_->setOnEnd([this](int code, const std::string& error) {
        if (!error.empty()) tellInDialog(error, "SulfurChamber cannot draw");
        finish(code);
    });
    Bind(wxEVT_CLOSE_WINDOW, &MainFrame::onClose, this);
    Bind(wxEVT_CHAR_HOOK, &MainFrame::onKey, this);
    SetMinSize(FromDIP(wxSize(640, 480)));
    const bool remembered = preferences_ && !options.sizeGiven;
    const atlax::PixelSize size =
        remembered ? preferences_->windowSize() : atlax::PixelSize{options.width, options.height};
    SetSize(size.width, size.height);
    if (remembered && preferences_->maximised()) Maximize();
    refresh();
}

MainFrame::~MainFrame() {
    manager_.UnInit();
}

void MainFrame::finish(int exitCode) {
    if (exitCode != 0) chamberApp().setExitCode(exitCode);
    setOnFrame({});
    savePreferences();
    manager_.UnInit();
    Destroy();
}

void MainFrame::onClose(wxCloseEvent& event) {
    if (event.CanVeto() && !mayDiscard()) {
        event.Veto();
        return;
    }
    finish(0);
}

// --- keys and actions ------------------------------------------------------------------------

void MainFrame::onKey(wxKeyEvent& event) {
    const wxWindow* focus = wxWindow::FindFocus();
    const bool typing = dynamic_cast<const wxTextEntry*>(focus) != nullptr;
    const bool own = focus != nullptr && wxGetTopLevelParent(const_cast<wxWindow*>(focus)) == this;
    if (typing || !own || event.ControlDown() || event.AltDown()) {
        event.Skip();
        return;
    }
    int key =
        event.GetUnicodeKey() != 0 ? static_cast<int>(event.GetUnicodeKey()) : event.GetKeyCode();
    if (key < 128) key = std::toupper(key);
    if (key == '=' || event.GetKeyCode() == WXK_NUMPAD_ADD) key = '+';
    if (event.GetKeyCode() == WXK_NUMPAD_SUBTRACT) key = '-';
    for (const Action& action : actions_)
        if (action.plainKey != 0 && action.plainKey == key) {
            runAction(action);
            return;
        }
    event.Skip();
}

bool MainFrame::perform(const std::string& name) {
    for (const Action& action : actions_) {
        if (action.name != name) continue;
        if (action.enabled && !action.enabled()) return false;
        runAction(action);
        return true;
    }
    return false;
}

void MainFrame::runAction(const Action& action) {
    if (action.enabled && !action.enabled()) return;
    try {
        action.run();
    } catch (const std::exception& error) {
        tell(error.what());
    }
    nextRefreshNs_ = 0;
}

// --- what is shown ---------------------------------------------------------------------------

void MainFrame::onFrame() {
    if (atlax::monotonicNs() >= nextRefreshNs_) {
        refresh();
        nextRefreshNs_ = atlax::monotonicNs() + refreshNs;
    }
    // A script may close the frame; it must not do so from inside of a frame's drawing.
    if (onFrame_)
        CallAfter([this] {
            if (onFrame_) onFrame_();
        });
}

void MainFrame::refresh() {
    const Document& document = bench_.document();
    const wxString title =
        (document.modified() ? wxString::FromUTF8("\xE2\x97\x8F ") : wxString()) +
        wxString::FromUTF8(document.name()) + wxString::FromUTF8(" \xE2\x80\x93 SulfurChamber");
    if (GetTitle() != title) SetTitle(title);
    constants_->refresh();
    refreshActions();
    refreshStatus();
}

void MainFrame::refreshActions() {
    wxMenuBar* menus = GetMenuBar();
    bool barsChanged = false;
    const bool playing = bench_.document().playing();
    for (const Action& action : actions_) {
        wxAuiToolBar* bar = toolBar_->FindTool(action.id) != nullptr   ? toolBar_
                            : palette_->FindTool(action.id) != nullptr ? palette_
                                                                       : nullptr;
        if (action.enabled) {
            const bool on = action.enabled();
            if (menus->IsEnabled(action.id) != on) menus->Enable(action.id, on);
            if (bar != nullptr && bar->GetToolEnabled(action.id) != on) {
                bar->EnableTool(action.id, on);
                barsChanged = true;
            }
        }
        if (action.checked) {
            const bool on = action.checked();
            if (menus->IsChecked(action.id) != on) menus->Check(action.id, on);
            if (bar != nullptr && bar->GetToolToggled(action.id) != on) {
                bar->ToggleTool(action.id, on);
                barsChanged = true;
            }
        }
        if (action.name == "play" && playing != shownPlaying_) {
            bar->SetToolBitmap(action.id, icon(playing ? "pause" : "play"));
            shownPlaying_ = playing;
            barsChanged = true;
        }
    }
    if (!barsChanged) return;
    toolBar_->Refresh();
    palette_->Refresh();
}

void MainFrame::refreshStatus() {
    const sulfur::World& world = bench_.document().world();
    const sulfur::Statistics& s = world.statistics();
    const Totals sums = totals(world);
    const std::array<wxString, 4> texts{
        wxString::FromUTF8(bench_.hint()),
        wxString::Format("%zu particles   %zu joints   %u contacts", sums.particles,
                         sums.rigidJoints + sums.elasticJoints, s.contacts),
        wxString::Format("%.0f %% of real time",
                         view_.realTimeShare() * view_.speedPermille() / 10.0),
        s.substeps > 1 ? wxString::Format("%d Hz, %u steps", world.settings().tickRate, s.substeps)
                       : wxString::Format("%d Hz", world.settings().tickRate)};
    for (std::size_t i = 0; i < texts.size(); ++i)
        if (GetStatusBar()->GetStatusText(static_cast<int>(i)) != texts[i])
            SetStatusText(texts[i], static_cast<int>(i));
}

void MainFrame::tell(const std::string& problem) {
    lastProblem_ = problem;
    if (options_.unattended())
        atlax::log(atlax::LogLevel::Warning, problem);
    else
        infoBar_->ShowMessage(wxString::FromUTF8(problem), wxICON_WARNING);
}

void MainFrame::tellInDialog(const std::string& problem, const wxString& title) {
    lastProblem_ = problem;
    if (options_.unattended()) {
        atlax::log(atlax::LogLevel::Warning, problem);
        return;
    }
    wxMessageDialog dialog(this, title, "SulfurChamber", wxOK | wxICON_ERROR);
    dialog.SetExtendedMessage(wxString::FromUTF8(problem));
    dialog.ShowModal();
}

void MainFrame::about() {
    wxAboutDialogInfo info;
    info.SetName("SulfurChamber");
    info.SetVersion(SULFURCHAMBER_VERSION);
    info.SetDescription(
        "Everything that moves is made of particles and joints.\n"
        "Build with them, pull at them, cut them, and watch.");
    info.SetLicence("MIT licence; see the file LICENSE of the project.");
    info.SetIcon(programIcon().GetIcon(wxSize(64, 64)));
    wxAboutBox(info, this);
}

}  // namespace sulfurchamber
