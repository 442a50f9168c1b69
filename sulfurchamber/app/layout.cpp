// How the window is put together.
#include <wx/aui/aui.h>
#include <wx/menu.h>
#include <wx/panel.h>
#include <wx/sizer.h>
#include <wx/statusbr.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "icons.hpp"
#include "level_panel.hpp"
#include "library_panel.hpp"
#include "main_frame.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

wxString keyText(int key) {
    for (const auto& [held, name] :
         {std::pair(withShift, "Shift"), {withControl, "Ctrl"}, {withAlt, "Alt"}})
        if ((key & held) != 0) return wxTr(name) + "+" + keyText(key & ~held);
    switch (key) {
        case WXK_INSERT:
            return wxTr("Ins");
        case 0:
            return "";
        case WXK_SPACE:
            return wxTr("Space");
        case WXK_DELETE:
            return wxTr("Del");
        case WXK_ESCAPE:
            return wxTr("Esc");
        case WXK_LEFT:
            return wxTr("Left");
        case WXK_RIGHT:
            return wxTr("Right");
        case WXK_UP:
            return wxTr("Up");
        case WXK_DOWN:
            return wxTr("Down");
        case WXK_RETURN:
            return wxTr("Enter");
        case WXK_HOME:
            return wxTr("Home");
        case WXK_END:
            return wxTr("End");
        case WXK_PAGEUP:
            return wxTr("Page Up");
        case WXK_PAGEDOWN:
            return wxTr("Page Down");
        default:
            return wxString(static_cast<wxChar>(key));
    }
}

wxUniChar mnemonicOf(const wxString& label) {
    for (std::size_t i = 0; i + 1 < label.length(); ++i) {
        if (label[i] != '&') continue;
        if (label[i + 1] != '&') return wxTolower(label[i + 1]);
        ++i;
    }
    return 0;
}

// Each entry of a menu has a letter of its own, in every language: of two with the same letter GTK
// opens neither. Who comes second takes the first free letter, at the beginning of a word if it can.
void giveMnemonics(const wxMenu& menu) {
    std::set<wxUniChar> taken;
    std::vector<wxMenuItem*> without;
    for (wxMenuItem* item : menu.GetMenuItems()) {
        if (item->IsSubMenu()) giveMnemonics(*item->GetSubMenu());
        if (item->IsSeparator()) continue;
        const wxUniChar letter = mnemonicOf(item->GetItemLabel());
        if (letter == 0 || !taken.insert(letter).second) without.push_back(item);
    }
    for (wxMenuItem* item : without) {
        const wxString keys = item->GetItemLabel().AfterFirst('\t');
        wxString text = item->GetItemLabelText();
        const auto find = [&](bool atWord) {
            for (std::size_t i = 0; i < text.length() && text[i] != '('; ++i)
                if (wxIsalnum(text[i]) && (!atWord || i == 0 || text[i - 1] == ' ') &&
                    !taken.contains(wxTolower(text[i])))
                    return i;
            return text.length();
        };
        std::size_t place = find(true);
        if (place == text.length()) place = find(false);
        if (place < text.length()) {
            taken.insert(wxTolower(text[place]));
            text.insert(place, "&");
        }
        item->SetItemLabel(keys.empty() ? text : text + "\t" + keys);
    }
}

}  // namespace

wxString MainFrame::tooltip(const Action& action) const {
    return withKey(wxString::FromUTF8(action.help), action);
}

wxString MainFrame::withKey(const wxString& text, const Action& action) const {
    const wxString accelerator = action.label.AfterFirst('\t');
    const wxString key = accelerator.empty() ? keyText(action.plainKey) : accelerator;
    return key.empty() ? text : text + "  (" + key + ")";
}

void MainFrame::makeMenus() {
    static const std::array<wxString, 8> titles{"&File",       "&Edit",    "&Tools", "&View",
                                                "&Simulation", "&Measure", "&Level", "&Help"};
    auto* bar = new wxMenuBar;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        auto* menu = new wxMenu;
        std::map<wxString, wxMenu*> inner;
        for (const Action& action : actions_) {
            if (static_cast<std::size_t>(action.menu) != i) continue;
            if (action.separatorBefore) menu->AppendSeparator();
            // Plain keys are no accelerators: GTK would take them away from text fields.
            wxString label = action.label;
            if (action.plainKey != 0) label += "   (" + keyText(action.plainKey) + ")";
            wxMenu* place = menu;
            if (!action.under.empty()) {
                wxMenu*& one = inner[action.under];
                if (one == nullptr) menu->AppendSubMenu(one = new wxMenu, "&" + wxTr(action.under));
                place = one;
            }
            place->Append(action.id, label, wxString::FromUTF8(action.help),
                          action.checked ? wxITEM_CHECK : wxITEM_NORMAL);
            if (action.name == "save-as") {
                recentMenu_ = new wxMenu;
                menu->AppendSubMenu(recentMenu_, wxTr("Open &recent"));
                recent_.UseMenu(recentMenu_);
            }
        }
        giveMnemonics(*menu);
        bar->Append(menu, wxTr(titles[i]));
    }
    SetMenuBar(bar);
    Bind(wxEVT_MENU_OPEN, [this](wxMenuEvent& event) {
        openMenus_.insert(event.GetMenu());
        event.Skip();
    });
    Bind(wxEVT_MENU_CLOSE, [this](wxMenuEvent& event) {
        openMenus_.erase(event.GetMenu());
        event.Skip();
    });
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
    secondPalette_ = new wxAuiToolBar(this, wxID_ANY, wxDefaultPosition, wxDefaultSize,
                                      style | wxAUI_TB_VERTICAL);
    for (wxAuiToolBar* bar : {toolBar_, palette_, secondPalette_}) {
        bar->SetToolBitmapSize(FromDIP(wxSize(24, 24)));
        bar->SetToolPacking(FromDIP(4));
    }
    const auto put = [&](wxAuiToolBar* bar, const Action& action) {
        wxString label = wxMenuItem::GetLabelText(action.label);
        bar->AddTool(action.id, label, icon(action.icon), tooltip(action),
                     action.checked ? wxITEM_CHECK : wxITEM_NORMAL);
    };
    // In the order of use, not of the menus.
    static constexpr std::array<const char*, 18> order{
        "new",  "open", "save", "", "undo", "redo", "",           "reset",  "tick-back",
        "play", "tick", "slow", "", "fit",  "grid", "velocities", "strain", "plot"};
    for (const std::string name : order) {
        if (name.empty()) toolBar_->AddSeparator();
        for (const Action& action : actions_)
            if (!name.empty() && action.name == name) put(toolBar_, action);
    }
    for (wxAuiToolBar* bar : {palette_, secondPalette_}) watchPalette(*bar);
    toolBar_->Realize();
    makePalette();
}

// Two columns, so that all of it fits into a small window: groups of tools, and beside them the
// tools of one. A click on a group takes the tool of it that was used last.
void MainFrame::makePalette() {
    for (const ToolGroupInfo& group : toolGroups()) {
        const int id = wxWindow::NewControlId();
        groupIds_[group.group] = id;
        const wxString title = wxTr(group.title);
        palette_->AddTool(id, title, icon(group.icon), title, wxITEM_CHECK);
        palette_->Bind(
            wxEVT_TOOL,
            [this, which = group.group](wxCommandEvent&) {
                bench_.setTool(lastTools_.at(which));
                followTool();
                nextRefreshNs_ = 0;
            },
            id);
    }
    for (const ToolKind tool : allTools()) lastTools_.emplace(groupOf(tool), tool);
    palette_->Realize();
    showGroup(ToolGroup::create);
}

void MainFrame::showGroup(ToolGroup group) {
    if (shownGroup_ == group) return;
    shownGroup_ = group;
    secondPalette_->ClearTools();
    for (const ToolKind tool : allTools()) {
        if (groupOf(tool) != group) continue;
        for (const Action& action : actions_)
            if (action.name == "tool-" + std::string(toolName(tool))) {
                secondPalette_->AddTool(action.id, wxMenuItem::GetLabelText(action.label),
                                        icon(action.icon), tooltip(action), wxITEM_CHECK);
                secondPalette_->ToggleTool(action.id, bench_.tool() == tool);
            }
    }
    secondPalette_->Realize();
    if (manager_.GetManagedWindow() == nullptr) return;
    manager_.GetPane(secondPalette_).BestSize(secondPalette_->GetSize());
    manager_.Update();
}

// The tool may have been chosen by a key. Selecting leaves the group that one builds with.
void MainFrame::followTool() {
    const ToolGroup group = groupOf(bench_.tool());
    if (bench_.tool() != ToolKind::place) lastTools_[group] = bench_.tool();
    for (const auto& [which, id] : groupIds_) {
        const bool on = which == group && bench_.tool() != ToolKind::place;
        if (palette_->GetToolToggled(id) != on) palette_->ToggleTool(id, on);
    }
    if (group != ToolGroup::select) showGroup(group);
    palette_->Refresh();
}

void MainFrame::makePanels() {
    centre_ = new wxPanel(this);
    infoBar_ = new wxInfoBar(centre_);
    atlax::WindowOptions window;
    window.maxFramesPerSecond = 60;
    window.tickRateHz = bench_.document().world().settings().tickRate;
    canvas_ = new atlax::wx::View(centre_, view_, window);
    side_ = new SidePanel(
        centre_, bench_, view_, desk_, thumbnails_,
        [this](const std::string& action) { perform(action); },
        [this](const std::string& problem) { tell(problem); });
    side_->library().onDropped = [this](const std::string& name, wxPoint at) {
        dropTemplate(name, at);
    };
    levelPanel_ = new LevelPanel(
        side_, bench_, *stage_, [this](const std::string& action) { perform(action); },
        [this](const std::string& problem) { tell(problem); });
    side_->addPage("level", levelPanel_, "Level");
    timeBar_ = new TimeBar(centre_, bench_, view_, [this](wxWindow& at) { chooseSpeed(at); });
    hint_ = new wxStaticText(centre_, wxID_ANY, "", wxDefaultPosition, wxDefaultSize,
                             wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    // What is told takes room of the scene, not of the panel, whose fields stay under the mouse.
    auto* column = new wxBoxSizer(wxVERTICAL);
    // The game's own clock waits for the first key.
    const auto played = [this] {
        return stage_->test() ? static_cast<double>(1 + stage_->test()->session().ticks()) /
                                    quaoar::Session::tickRate
                              : 0;
    };
    lesson_ = new LessonPanel(
        centre_, bench_, view_, [this](const std::string& name) { perform(name); }, played);
    column->Add(infoBar_, wxSizerFlags(0).Expand());
    column->Add(lesson_, wxSizerFlags(0).Expand());
    column->Add(canvas_, wxSizerFlags(1).Expand());
    plot_ = new PlotPanel(centre_, bench_,
                          [this](const wxString& under, wxWindow& at) { chooseUnder(under, at); });
    plot_->Hide();
    column->Add(plot_, wxSizerFlags(0).Expand());
    auto* row = new wxBoxSizer(wxHORIZONTAL);
    row->Add(column, wxSizerFlags(1).Expand());
    row->Add(side_, wxSizerFlags(0).Expand());
    auto* sizer = new wxBoxSizer(wxVERTICAL);
    sizer->Add(row, wxSizerFlags(1).Expand());
    sizer->Add(timeBar_, wxSizerFlags(0).Expand());
    sizer->Add(hint_, wxSizerFlags(0).Expand().Border(wxALL, FromDIP(3)));
    centre_->SetSizer(sizer);

    manager_.SetManagedWindow(this);
    manager_.GetArtProvider()->SetMetric(wxAUI_DOCKART_PANE_BORDER_SIZE, 0);
    manager_.AddPane(centre_, wxAuiPaneInfo().Name("scene").CenterPane());
    manager_.AddPane(toolBar_, wxAuiPaneInfo().Name("bar").ToolbarPane().Top().Gripper(false));
    manager_.AddPane(palette_,
                     wxAuiPaneInfo().Name("tools").ToolbarPane().Left().Row(0).Gripper(false));
    manager_.AddPane(secondPalette_,
                     wxAuiPaneInfo().Name("tools2").ToolbarPane().Left().Row(1).Gripper(false));
    manager_.Update();
    // GTK loses what it is asked for while it gives out sizes: pages that are hidden then would
    // stay as large as they were.
    Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
        event.Skip();
        CallAfter([this] { arrange(); });
    });
}

// The side panel takes about a third of a small window, and no more than it needs of a large one;
// the diagram about a third of the height, pictures of the past a twentieth. In a narrow window
// hints have two lines.
void MainFrame::arrange() {
    const wxSize size = GetClientSize();
    const int wanted = std::clamp(size.GetWidth() * 36 / 100, FromDIP(240), FromDIP(312));
    const int plot = std::clamp(size.GetHeight() * 3 / 10, FromDIP(120), FromDIP(300));
    const bool pictures =
        timeBar_->setPictureHeight(std::clamp(size.GetHeight() / 20, FromDIP(24), FromDIP(45)));
    const int hint = hint_->GetCharHeight() * (size.GetWidth() < FromDIP(1000) ? 2 : 1);
    if (side_->GetMinSize().GetWidth() == wanted && plot_->GetMinSize().GetHeight() == plot &&
        hint_->GetMinSize().GetHeight() == hint && !pictures)
        return;
    hint_->SetMinSize(wxSize(-1, hint));
    side_->SetMinSize(wxSize(wanted, -1));
    plot_->SetMinSize(wxSize(-1, plot));
    centre_->Layout();
}

void MainFrame::showSide(bool on) {
    side_->Show(on);
    centre_->Layout();
}

void MainFrame::makeStatusBar() {
    constexpr int fields = 4;
    CreateStatusBar(fields);
    const std::array<int, fields> widths{-1, 0, FromDIP(140), FromDIP(112)};
    SetStatusWidths(fields, widths.data());
    SetStatusBarPane(-1);  // menus' help would hide the numbers
    GetStatusBar()->Bind(wxEVT_LEFT_DOWN, &MainFrame::onStatusClick, this);
}

}  // namespace sulfurchamber
