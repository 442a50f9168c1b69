// How the window is put together.
#include <wx/aui/aui.h>
#include <wx/menu.h>
#include <wx/panel.h>
#include <wx/sizer.h>
#include <wx/statusbr.h>

#include <array>

#include "icons.hpp"
#include "main_frame.hpp"

namespace sulfurchamber {
namespace {

wxString keyText(int key) {
    switch (key) {
        case 0:
            return "";
        case WXK_SPACE:
            return "Space";
        case WXK_DELETE:
            return "Del";
        case WXK_ESCAPE:
            return "Esc";
        default:
            return wxString(static_cast<wxChar>(key));
    }
}

}  // namespace

wxString MainFrame::tooltip(const Action& action) const {
    wxString text = wxString::FromUTF8(action.help);
    const wxString accelerator = action.label.AfterFirst('\t');
    const wxString key = accelerator.empty() ? keyText(action.plainKey) : accelerator;
    return key.empty() ? text : text + "  (" + key + ")";
}

void MainFrame::makeMenus() {
    static const std::array<wxString, 6> titles{"&File", "&Edit",       "&Tools",
                                                "&View", "&Simulation", "&Help"};
    auto* bar = new wxMenuBar;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        auto* menu = new wxMenu;
        for (const Action& action : actions_) {
            if (static_cast<std::size_t>(action.menu) != i) continue;
            if (action.separatorBefore) menu->AppendSeparator();
            // Plain keys are no accelerators: GTK would take them away from text fields.
            wxString label = action.label;
            if (action.plainKey != 0) label += "   (" + keyText(action.plainKey) + ")";
            menu->Append(action.id, label, wxString::FromUTF8(action.help),
                         action.checked ? wxITEM_CHECK : wxITEM_NORMAL);
            if (action.name == "save-as") {
                recentMenu_ = new wxMenu;
                menu->AppendSubMenu(recentMenu_, "Open &recent");
                recent_.UseMenu(recentMenu_);
            }
        }
        bar->Append(menu, titles[i]);
    }
    SetMenuBar(bar);
    Bind(wxEVT_MENU, [this](wxCommandEvent& event) {
        const int recent = event.GetId() - recent_.GetBaseId();
        if (recent >= 0 && recent < static_cast<int>(recent_.GetCount())) {
            openRecent(recent);
            return;
        }
        for (const Action& action : actions_)
            if (action.id == event.GetId()) {
                runAction(action);
                return;
            }
        event.Skip();
    });
}

void MainFrame::makeBars() {
    const long style = wxAUI_TB_PLAIN_BACKGROUND;
    toolBar_ = new wxAuiToolBar(this, wxID_ANY, wxDefaultPosition, wxDefaultSize, style);
    palette_ = new wxAuiToolBar(this, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                                style | wxAUI_TB_VERTICAL);
    for (wxAuiToolBar* bar : {toolBar_, palette_}) {
        bar->SetToolBitmapSize(FromDIP(wxSize(24, 24)));
        bar->SetToolPacking(FromDIP(4));
    }
    const auto put = [&](wxAuiToolBar* bar, const Action& action) {
        wxString label = wxMenuItem::GetLabelText(action.label);
        bar->AddTool(action.id, label, icon(action.icon), tooltip(action),
                     action.checked ? wxITEM_CHECK : wxITEM_NORMAL);
    };
    // In the order of use, not of the menus.
    static constexpr std::array<const char*, 16> order{
        "new",  "open", "save", "", "undo", "redo", "",           "reset",
        "play", "tick", "slow", "", "fit",  "grid", "velocities", "strain"};
    for (const std::string name : order) {
        if (name.empty()) toolBar_->AddSeparator();
        for (const Action& action : actions_)
            if (!name.empty() && action.name == name) put(toolBar_, action);
    }
    for (const Action& action : actions_) {
        if (action.menu != MenuId::tools) continue;
        if (action.separatorBefore) palette_->AddSeparator();
        put(palette_, action);
    }
    toolBar_->Realize();
    palette_->Realize();
}

void MainFrame::makePanels() {
    centre_ = new wxPanel(this);
    infoBar_ = new wxInfoBar(centre_);
    atlax::WindowOptions window;
    window.maxFramesPerSecond = 60;
    window.tickRateHz = bench_.document().world().settings().tickRate;
    canvas_ = new atlax::wx::View(centre_, view_, window);
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(infoBar_, wxSizerFlags(0).Expand());
    sizer->Add(canvas_, wxSizerFlags(1).Expand());
    centre_->SetSizer(sizer);
    constants_ = new ConstantsPanel(this, bench_, view_);

    manager_.SetManagedWindow(this);
    manager_.GetArtProvider()->SetMetric(wxAUI_DOCKART_PANE_BORDER_SIZE, 0);
    manager_.AddPane(centre_, wxAuiPaneInfo().Name("scene").CenterPane());
    manager_.AddPane(toolBar_, wxAuiPaneInfo().Name("bar").ToolbarPane().Top().Gripper(false));
    manager_.AddPane(palette_, wxAuiPaneInfo().Name("tools").ToolbarPane().Left().Gripper(false));
    manager_.AddPane(constants_, wxAuiPaneInfo()
                                     .Name("constants")
                                     .Right()
                                     .CaptionVisible(false)
                                     .CloseButton(false)
                                     .BestSize(FromDIP(wxSize(312, 600)))
                                     .MinSize(FromDIP(wxSize(300, 200))));
    manager_.Update();
}

void MainFrame::makeStatusBar() {
    constexpr int fields = 4;
    const std::array<int, fields> widths{-1, FromDIP(330), FromDIP(150), FromDIP(160)};
    CreateStatusBar(fields);
    SetStatusWidths(fields, widths.data());
    SetStatusBarPane(-1);  // menus' help would hide the hint
}

}  // namespace sulfurchamber
