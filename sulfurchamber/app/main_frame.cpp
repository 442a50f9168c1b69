#include "main_frame.hpp"

#include <wx/aboutdlg.h>
#include <wx/app.h>
#include <wx/arrstr.h>
#include <wx/gdicmn.h>
#include <wx/image.h>
#include <wx/listctrl.h>
#include <wx/menu.h>
#include <wx/msgdlg.h>
#include <wx/spinctrl.h>
#include <wx/textctrl.h>

#include <algorithm>
#include <array>
#include <atlax/backend.hpp>
#include <atlax/files.hpp>
#include <atlax/log.hpp>
#include <cctype>
#include <set>

#include "../model/geometry.hpp"
#include "../model/refusals.hpp"
#include "chamber_app.hpp"
#include "icons.hpp"
#include "level_panel.hpp"
#include "measure_panel.hpp"
#include "picture_grid.hpp"
#include "program_files.hpp"
#include "value_row.hpp"
#include "wrapped_text.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

SkinTextures* withSkins(SceneView& view) {
    view.setSkins(skinStore());
    return view.textures();
}

constexpr std::int64_t refreshNs = 100'000'000;  // panels follow ten times a second

}  // namespace

MainFrame::MainFrame(Workbench& bench, const Options& options)
    : wxFrame(nullptr, wxID_ANY, "SulfurChamber"),
      bench_(bench),
      options_(options),
      view_(bench),
      library_(templateLibrary()),
      desk_(bench_, library_),
      thumbnails_(atlax::cacheFolder("sulfurchamber") / "thumbnails", withSkins(view_), {192, 144}),
      language_(options.language),
      theme_(options.theme) {
    wxUpdateUIEvent::SetMode(wxUPDATE_UI_PROCESS_SPECIFIED);  // refresh() does it, less often
    SetIcons(wxIconBundle(programIcon().GetIcon(wxSize(64, 64))));
    actions_.reserve(256);
    stage_ = std::make_unique<LevelStage>(bench_, view_);
    makeActions();
    makeDropUses();
    makeMenus();
    makeBars();
    makePanels();
    makeStatusBar();
    bindControls();
    loadPreferences();
    view_.onFile = [this](const std::filesystem::path& file) {
        CallAfter([this, file] { dropFile(file); });  // who drops waits for us until then
    };
    view_.onProblem = [this](const std::string& problem) { tell(problem); };
    view_.onFilm = [this](const std::filesystem::path& file) {
        notify(tr("The film is {}", {file.string()}));
    };
    view_.onFrame = [this] { onFrame(); };
    view_.busy = [this] {
        const bool filmComes =
            pointedTool_ && view_.options().films && view_.guide().film() != pointedTool_;
        const bool works = thumbnails_.working() || side_->measures().searching();
        return onFrame_ || filmComes || works;
    };
    view_.whileDrawing = [this](atlax::Canvas& canvas) { thumbnails_.work(canvas); };
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
    // Else GTK lays it out without room for what the window manager puts around it, and complains.
    SetClientSize(GetClientSize());
    if (remembered && preferences_->maximised()) Maximize();
    refresh();
}

MainFrame::~MainFrame() {
    canvas_->stop();  // what it draws ends before it
    delete gallery_;  // it uses the pictures, which go before what the frame owns
    manager_.UnInit();
}

void MainFrame::finish(int exitCode) {
    if (exitCode != 0) chamberApp().setExitCode(exitCode);
    setOnFrame({});
    savePreferences();
    recovery_.reset();
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

namespace {

// As the keys of what is driven are called; "" for others.
std::string controlKeyOf(const wxKeyEvent& event) {
    switch (event.GetKeyCode()) {
        case WXK_LEFT:
            return "Left";
        case WXK_RIGHT:
            return "Right";
        case WXK_UP:
            return "Up";
        case WXK_DOWN:
            return "Down";
        default:
            break;
    }
    const int code = std::toupper(event.GetKeyCode() < 128 ? event.GetKeyCode() : 0);
    return code >= 'A' && code <= 'Z' ? std::string(1, static_cast<char>(code)) : "";
}

}  // namespace

// While time runs, keys that drive something do nothing else. They are let go where they were
// taken: the drawing area gets the focus.
bool MainFrame::holdControl(const wxKeyEvent& event) {
    const std::string key = controlKeyOf(event);
    if (key.empty() || !bench_.document().playing() || !answersTo(bench_.document(), key))
        return false;
    canvas_->SetFocus();
    bench_.controls().hold(key, true);
    return true;
}

void MainFrame::bindControls() {
    canvas_->Bind(wxEVT_KEY_UP, [this](wxKeyEvent& event) {
        event.Skip();
        bench_.controls().hold(controlKeyOf(event), false);
    });
    canvas_->Bind(wxEVT_KILL_FOCUS, [this](wxFocusEvent& event) {
        event.Skip();
        bench_.controls().release();
    });
}

// Tab goes from the scene to the side panel and on through it, where the keys of what has the focus
// are its own; Escape goes back. Who has clicked there goes on with the keys of the scene.
bool MainFrame::walkPanel(wxKeyEvent& event, const wxWindow* focus) {
    if (focus == nullptr || event.ControlDown() || event.AltDown()) return false;
    const int key = event.GetKeyCode();
    const bool inPanel = side_->IsDescendant(const_cast<wxWindow*>(focus));
    if (!inPanel) walksPanel_ = false;
    if (key == WXK_TAB && openMenus_.empty() && (inPanel || focus == canvas_)) {
        walksPanel_ = true;
        if (inPanel || !side_->IsShown())
            event.Skip();
        else
            side_->SetFocus();
        return true;
    }
    const auto* text = dynamic_cast<const wxTextEntry*>(focus);
    const auto* field = dynamic_cast<const wxTextCtrl*>(focus);
    const bool isText = text != nullptr;
    const bool isAsItWas = isText && (field != nullptr ? !field->IsModified() : text->IsEmpty());
    const bool mayLeave = isText ? isAsItWas : walksPanel_;
    if (inPanel && key == WXK_ESCAPE && mayLeave) {
        canvas_->SetFocus();
        return true;
    }
    static const std::set<int> ofWidgets{WXK_SPACE, WXK_RETURN, WXK_LEFT, WXK_RIGHT,  WXK_UP,
                                         WXK_DOWN,  WXK_HOME,   WXK_END,  WXK_PAGEUP, WXK_PAGEDOWN};
    if (!walksPanel_ || !inPanel || isText || !ofWidgets.contains(key)) return false;
    event.Skip();
    return true;
}

void MainFrame::onKey(wxKeyEvent& event) {
    const wxWindow* focus = wxWindow::FindFocus();
    // Fields, grids and open menus have keys of their own.
    const bool typing = !openMenus_.empty() || dynamic_cast<const wxTextEntry*>(focus) != nullptr ||
                        dynamic_cast<const PictureGrid*>(focus) != nullptr;
    // While a level is played its keys are the game's, but for the one that ends it.
    if (stage_->playing() && !typing && !event.ControlDown() && !event.AltDown()) {
        if (event.GetKeyCode() == WXK_ESCAPE)
            stage_->endPlay();
        else
            event.Skip();
        return;
    }
    if (walkPanel(event, focus)) return;
    const bool own = focus != nullptr && wxGetTopLevelParent(const_cast<wxWindow*>(focus)) == this;
    const bool command = event.ControlDown() || event.AltDown();
    if (typing || !own) {
        event.Skip();
        return;
    }
    if (!command && holdControl(event)) return;
    int key =
        event.GetUnicodeKey() != 0 ? static_cast<int>(event.GetUnicodeKey()) : event.GetKeyCode();
    if (key < 128) key = std::toupper(key);
    if (key == '=' || event.GetKeyCode() == WXK_NUMPAD_ADD) key = '+';
    if (event.GetKeyCode() == WXK_NUMPAD_SUBTRACT) key = '-';
    // What Shift makes of a letter or a sign is a key of its own.
    const bool same = key == WXK_LEFT || key == WXK_RIGHT || key == WXK_UP || key == WXK_DOWN ||
                      key == WXK_INSERT;
    if (same && event.ShiftDown()) key |= withShift;
    if (event.ControlDown()) key |= withControl;
    if (event.AltDown()) key |= withAlt;
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

std::string MainFrame::menuLabel(const std::string& name) const {
    for (const Action& action : actions_)
        if (action.name == name)
            return wxMenuItem::GetLabelText(GetMenuBar()->GetLabel(action.id)).utf8_string();
    return "";
}

namespace {

// A number at the end of a line, and its unit on the next one.
bool partsUnit(const wxString& line, const wxString& next) {
    if (line.empty() || !wxIsdigit(line.Last())) return false;
    wxString word = next.BeforeFirst(' ');
    while (!word.empty() && wxIspunct(word.Last()) && word != "%") word.RemoveLast();
    return word == "%" || word == "s" || word == "m" || word == "kg" || word == "N" || word == "J";
}

// A line may be too long for its text, and the lines too many.
void addCutText(const wxStaticText& text, std::vector<std::string>& cut) {
    if (text.GetLabelText().empty()) return;
    const wxArrayString lines = wxSplit(text.GetLabelText(), '\n', '\0');
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (text.GetTextExtent(lines[i]).GetWidth() > text.GetSize().GetWidth() ||
            (i > 0 && partsUnit(lines[i - 1], lines[i])))
            cut.push_back(lines[i].utf8_string());
    if (static_cast<int>(lines.size()) * text.GetCharHeight() > text.GetSize().GetHeight())
        cut.push_back(text.GetLabelText().utf8_string());
}

// Words may be longer than their field, but neither numbers nor what an empty one says.
void addCutText(const wxTextCtrl& field, std::vector<std::string>& cut) {
    if (!field.IsEmpty() && !field.HasFlag(wxTE_RIGHT)) return;
    const wxString text = field.IsEmpty() ? field.GetHint() : field.GetValue();
    if (field.GetTextExtent(text).GetWidth() + field.FromDIP(fieldEdges) >
        field.GetSize().GetWidth())
        cut.push_back(text.utf8_string());
}

void addCutText(const wxListCtrl& list, std::vector<std::string>& cut) {
    constexpr int edges = 8;  // pixels that the list keeps free
    const auto look = [&](const wxString& text, int column) {
        if (list.GetTextExtent(text).GetWidth() + edges > list.GetColumnWidth(column))
            cut.push_back(text.utf8_string());
    };
    for (int column = 0; column < list.GetColumnCount(); ++column) {
        wxListItem head;
        head.SetMask(wxLIST_MASK_TEXT);
        if (list.GetColumn(column, head)) look(head.GetText(), column);
        for (int row = 0; row < list.GetItemCount(); ++row)
            look(list.GetItemText(row, column), column);
    }
}

void addCutTexts(const wxWindow& window, std::vector<std::string>& cut) {
    if (!window.IsShown()) return;
    if (const auto* text = dynamic_cast<const wxStaticText*>(&window)) addCutText(*text, cut);
    if (const auto* field = dynamic_cast<const wxTextCtrl*>(&window)) addCutText(*field, cut);
    if (const auto* list = dynamic_cast<const wxListCtrl*>(&window)) addCutText(*list, cut);
    for (const wxWindow* child : window.GetChildren()) addCutTexts(*child, cut);
}

}  // namespace

namespace {

// Menus that are higher than the screen, with those in them. An entry is a line of text with room.
void addHighMenus(const wxWindow& window, const wxMenu& menu, const wxString& title,
                  std::vector<std::string>& cut) {
    int height = 0;
    for (const wxMenuItem* item : menu.GetMenuItems()) {
        height +=
            item->IsSeparator() ? window.FromDIP(7) : window.GetCharHeight() + window.FromDIP(9);
        if (const wxMenu* inner = item->GetSubMenu())
            addHighMenus(window, *inner, item->GetItemLabelText(), cut);
    }
    if (height > wxGetDisplaySize().GetHeight() - window.FromDIP(28))
        cut.push_back(tr("the menu {}", {title.utf8_string()}));
}

}  // namespace

std::vector<std::string> MainFrame::cutTexts() const {
    std::vector<std::string> cut;
    for (std::size_t i = 0; i < GetMenuBar()->GetMenuCount(); ++i)
        addHighMenus(*this, *GetMenuBar()->GetMenu(i), GetMenuBar()->GetMenuLabelText(i), cut);
    addCutTexts(*centre_, cut);
    if (const wxWindow* experiment = table4_.get()) addCutTexts(*experiment, cut);
    for (int i = 0; i < GetStatusBar()->GetFieldsCount(); ++i) {
        wxRect place;
        GetStatusBar()->GetFieldRect(i, place);
        const wxString text = GetStatusBar()->GetStatusText(i);
        if (!text.empty() && GetStatusBar()->GetTextExtent(text).GetWidth() > place.GetWidth())
            cut.push_back(text.utf8_string());
    }
    return cut;
}

void MainFrame::runAction(const Action& action) {
    if (action.enabled && !action.enabled()) return;
    lastAction_ = action.name;
    try {
        action.run();
    } catch (const std::exception& error) {
        tell(error.what());
    }
    nextRefreshNs_ = 0;
}

// --- what is shown ---------------------------------------------------------------------------

void MainFrame::onFrame() {
    stage_->follow();
    refreshGuide();
    if (view_.seeking()) {
        timeBar_->refresh();
        plot_->refresh();
    }
    if (atlax::monotonicNs() >= nextRefreshNs_) {
        refresh();
        if (table4_) table4_->refresh();
        keepUnsaved();
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
    // Who goes on has read it.
    if (infoBar_->IsShown() && document.revision() != toldAt_) infoBar_->Dismiss();
    strays_ = bench_.strays().size();
    side_->refresh();
    timeBar_->refresh();
    plot_->refresh();
    followTool();
    if (side_->GetCurrentPage() == levelPanel_) levelPanel_->refresh();
    refreshActions();
    refreshHistoryLabels();
    refreshStatus();
}

// Undo and redo say what they do.
void MainFrame::refreshHistoryLabels() {
    const auto tell = [this](const char* name, const std::string& verb, const std::string& step,
                             std::string& shown) {
        const std::string text = step.empty() ? tr(verb) : tr("{} “{}”", {tr(verb), tr(step)});
        if (text == shown) return;
        shown = text;
        for (const Action& action : actions_) {
            if (action.name != name) continue;
            const wxString key = action.label.AfterFirst('\t');
            const wxString label = "&" + wxString::FromUTF8(text);
            GetMenuBar()->SetLabel(action.id, label + "\t" + key);
            toolBar_->SetToolShortHelp(action.id, wxString::FromUTF8(text) + "  (" + key + ")");
        }
    };
    const Document& document = bench_.document();
    tell("undo", "Undo", document.undoLabel(), shownUndo_);
    tell("redo", "Redo", document.redoLabel(), shownRedo_);
}

void MainFrame::refreshActions() {
    wxMenuBar* menus = GetMenuBar();
    bool barsChanged = false;
    const bool playing = bench_.document().playing();
    for (const Action& action : actions_) {
        wxAuiToolBar* bar = nullptr;
        for (wxAuiToolBar* one : {toolBar_, palette_, secondPalette_})
            if (one->FindTool(action.id) != nullptr) bar = one;
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
    secondPalette_->Refresh();
}

// The longest of the texts that fits into a field.
void MainFrame::setStatus(int field, const std::vector<wxString>& variants) {
    wxRect place;
    GetStatusBar()->GetFieldRect(field, place);
    const int room = place.GetWidth() - FromDIP(8);
    const auto fits = [&](const wxString& text) {
        return GetStatusBar()->GetTextExtent(text).GetWidth() <= room;
    };
    const auto found = std::find_if(variants.begin(), variants.end(), fits);
    const wxString& text = found == variants.end() ? variants.back() : *found;
    if (GetStatusBar()->GetStatusText(field) != text) SetStatusText(text, field);
}

void MainFrame::showHint() {
    const wxString hint = wxTr(bench_.hint());
    const int width = centre_->GetClientSize().GetWidth() - FromDIP(8);
    if (hint == shownHint_ && width == hintWidth_) return;
    shownHint_ = hint;
    hintWidth_ = width;
    showWrapped(*hint_, hint, width);
    hint_->SetToolTip(hint);
}

void MainFrame::refreshStatus() {
    showHint();
    const sulfur::World& world = bench_.document().world();
    const sulfur::Statistics& s = world.statistics();
    const Totals sums = totals(world);
    const wxString particles = wxTrCount("{} particle", "{} particles", sums.particles);
    const wxString joints =
        "   " + wxTrCount("{} joint", "{} joints", sums.rigidJoints + sums.elasticJoints);
    const wxString contacts = "   " + wxTrCount("{} contact", "{} contacts", s.contacts);
    const std::string slowness = view_.slowness();
    const int strayWidth = strays_ > 0 ? FromDIP(130) : 0;
    const int paceWidth = FromDIP(slowness.empty() ? 140 : 260);
    if (GetStatusBar()->GetStatusWidth(1) != strayWidth ||
        GetStatusBar()->GetStatusWidth(2) != paceWidth) {
        // GTK cannot redraw a text where there is no room any more.
        if (strayWidth == 0) SetStatusText("", 1);
        if (slowness.empty()) SetStatusText("", 2);
        const std::array<int, 4> widths{-1, strayWidth, paceWidth, FromDIP(112)};
        SetStatusWidths(4, widths.data());
    }
    setStatus(0, {particles + joints + contacts, particles + joints, particles});
    if (strays_ > 0) setStatus(1, {wxTr("{} out of bounds", {std::to_string(strays_)})});
    const wxString pace =
        wxTr("{} % of real time", {fixed(view_.realTimeShare() * view_.speedPermille() / 10.0, 0)});
    setStatus(2, {slowness.empty() ? pace : pace + ": " + wxString::FromUTF8(slowness), pace});
    const wxString rate = wxString::Format("%d Hz", world.settings().tickRate);
    setStatus(
        3, {s.substeps > 1 ? rate + wxTr(", {} steps", {std::to_string(s.substeps)}) : rate, rate});
    tellWhenNearlyFull(sums.particles);
}

void MainFrame::tellWhenNearlyFull(std::size_t particles) {
    constexpr std::size_t most = sulfur::scene::Limits::particles;
    if (toldNearlyFull_ || particles * 5 < most * 4) return;
    toldNearlyFull_ = true;
    tell(tr("The scene has {} particles; at {} it is full, because files hold no more.",
            {std::to_string(particles), std::to_string(most)}));
}

// What has left can be brought back from where it is counted.
void MainFrame::onStatusClick(wxMouseEvent& event) {
    event.Skip();
    wxRect place;
    GetStatusBar()->GetFieldRect(1, place);
    if (strays_ == 0 || !place.Contains(event.GetPosition())) return;
    wxMenu menu;
    for (const Action& action : actions_)
        if (action.name == "bring-back" || action.name == "delete-strays")
            menu.Append(action.id, action.label, wxString::FromUTF8(action.help));
    GetStatusBar()->PopupMenu(&menu, place.GetTopLeft());
}

void MainFrame::tell(const std::string& english) {
    const std::string problem = trRefusal(english);
    lastProblem_ = problem;
    if (options_.unattended())
        atlax::log(atlax::LogLevel::Warning, problem);
    else
        infoBar_->ShowMessage(wxString::FromUTF8(problem), wxICON_WARNING);
    toldAt_ = bench_.document().revision();
}

void MainFrame::notify(const std::string& english) {
    const std::string news = tr(english);
    if (options_.unattended())
        atlax::log(atlax::LogLevel::Info, news);
    else
        infoBar_->ShowMessage(wxString::FromUTF8(news), wxICON_INFORMATION);
    toldAt_ = bench_.document().revision();
}

void MainFrame::tellInDialog(const std::string& english, const wxString& title) {
    const std::string problem = trRefusal(english);
    lastProblem_ = problem;
    if (options_.unattended()) {
        atlax::log(atlax::LogLevel::Warning, problem);
        return;
    }
    wxMessageDialog dialog(this, wxTr(title), "SulfurChamber", wxOK | wxICON_ERROR);
    dialog.SetExtendedMessage(wxString::FromUTF8(problem));
    dialog.ShowModal();
}

void MainFrame::chooseLanguage(const std::string& language) {
    language_ = language;
    if (preferences_) {
        preferences_->setLanguage(language);
        preferences_->save();
    }
    notify("The language changes when SulfurChamber starts again");
}

// GTK takes a theme only when it starts.
void MainFrame::chooseTheme(const std::string& theme) {
    theme_ = theme;
    if (preferences_) {
        preferences_->setTheme(theme);
        preferences_->save();
    }
    notify("The theme changes when SulfurChamber starts again");
}

void MainFrame::about() {
    wxAboutDialogInfo info;
    info.SetName("SulfurChamber");
    info.SetVersion(SULFURCHAMBER_VERSION);
    info.SetDescription(
        wxTr("Everything that moves is made of particles and joints.\n"
             "Build with them, pull at them, cut them, and watch."));
    info.SetLicence(wxTr("MIT licence; see the file LICENSE of the project."));
    info.SetIcon(programIcon().GetIcon(wxSize(64, 64)));
    wxAboutBox(info, this);
}

}  // namespace sulfurchamber
