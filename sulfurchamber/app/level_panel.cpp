#include "level_panel.hpp"

#include <wx/bmpbndl.h>
#include <wx/wrapsizer.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "icons.hpp"
#include "small_button.hpp"
#include "wrapped_text.hpp"
#include "wx_words.hpp"

namespace sulfurchamber {
namespace {

wxString shownText(std::string_view text) {
    return wxString::FromUTF8(text.data(), text.size());
}

// What is shown of a choice; the file keeps the English words.
wxArrayString wordsOf(const LevelField& field) {
    wxArrayString words;
    for (const std::string& word : choicesOf(field)) words.Add(wxTr(word));
    return words;
}

void select(wxChoice* choice, const LevelField& field, const std::string& word) {
    const auto words = choicesOf(field);
    const auto found = std::find(words.begin(), words.end(), word);
    choice->SetSelection(found == words.end() ? wxNOT_FOUND
                                              : static_cast<int>(found - words.begin()));
}

// Keeps the place where one has scrolled to.
void setLines(wxListBox* list, const std::vector<std::string>& lines) {
    wxArrayString items;
    for (const std::string& line : lines) items.Add(shownText(line));
    list->Set(items);
}

}  // namespace

void changeField(Document& document, const LevelThing& thing, const LevelField& field,
                 const std::string& text) {
    const std::string label = tr(
        "Change {}, {}", {tr(std::string(infoOf(field.kind).name)), tr(std::string(field.name))});
    document.edit(label, [&] { setField(document, thing, field, text); });
}

LevelPanel::LevelPanel(wxWindow* parent, Workbench& bench, LevelStage& stage,
                       std::function<void(const std::string&)> perform,
                       std::function<void(const std::string&)> refuse)
    : wxScrolledWindow(parent, wxID_ANY, wxDefaultPosition, wxDefaultSize, wxVSCROLL),
      bench_(bench),
      stage_(stage),
      perform_(std::move(perform)),
      refuse_(std::move(refuse)) {
    auto* all = new wxBoxSizer(wxVERTICAL);
    start_ = new wxBoxSizer(wxVERTICAL);
    level_ = new wxBoxSizer(wxVERTICAL);
    makeStart(start_);
    makePalette(level_);
    makeProof(level_);
    makeLists(level_);
    all->Add(start_, wxSizerFlags(0).Expand());
    all->Add(level_, wxSizerFlags(1).Expand());
    auto* border = new wxBoxSizer(wxVERTICAL);
    border->Add(all, wxSizerFlags(1).Expand().Border(wxALL, FromDIP(8)));
    SetSizer(border);
    SetScrollRate(0, FromDIP(12));
    Bind(wxEVT_SIZE, [this](wxSizeEvent& event) {
        event.Skip();
        wrapProof();
    });
    refresh();
}

// --- making ----------------------------------------------------------------------------------

wxStaticText* LevelPanel::heading(const wxString& text) {
    auto* made = new wxStaticText(this, wxID_ANY, wxTr(text), wxDefaultPosition, wxDefaultSize,
                                  wxST_NO_AUTORESIZE | wxST_ELLIPSIZE_END);
    made->SetFont(made->GetFont().Bold());
    return made;
}

wxButton* LevelPanel::button(const wxString& label, const wxString& help, const char* action) {
    auto* made = smallButton(this, wxTr(label));
    made->SetToolTip(wxTr(help));
    made->Bind(wxEVT_BUTTON,
               [this, name = std::string(action)](wxCommandEvent&) { perform_(name); });
    return made;
}

void LevelPanel::makeStart(wxSizer* sizer) {
    sizer->Add(heading("This scene is no level"),
               wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    sizer->Add(button("Make a level of it", "Adds a spawn, an exit and bounds", "level-make"),
               wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(4)));
    sizer->Add(button("New level", "A small level to begin with", "level-new"),
               wxSizerFlags(0).Expand());
}

void LevelPanel::makePalette(wxSizer* sizer) {
    sizer->Add(heading("Place"), wxSizerFlags(0).Expand());
    auto* palette = new wxWrapSizer(wxHORIZONTAL);
    for (const LevelPieceInfo& info : levelPieces()) {
        const std::string name(info.name);
        auto* one = new wxBitmapToggleButton(this, wxID_ANY, icon("level-" + name),
                                             wxDefaultPosition, wxDefaultSize, wxBU_EXACTFIT);
        wxString label = wxTr(info.label);
        label.Replace("&", "");
        one->SetToolTip(label + ": " + wxTr(info.hint));
        one->Bind(wxEVT_TOGGLEBUTTON, [this, name](wxCommandEvent&) { perform_("place-" + name); });
        pieces_.push_back(one);
        palette->Add(one);
    }
    sizer->Add(palette, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
}

void LevelPanel::makeProof(wxSizer* sizer) {
    auto* row = new wxWrapSizer(wxHORIZONTAL);
    row->Add(button("Play", "Play the level here (F5)", "level-play"));
    solve_ = smallButton(this, wxTr("Can it be finished?"));
    solve_->SetToolTip(wxTr("Search for a way through the level (F6), or stop it"));
    solve_->Bind(wxEVT_BUTTON, [this](wxCommandEvent&) {
        const SearchJob* job = stage_.desk().job();
        perform_(job != nullptr && !job->progress().over() ? "level-stop" : "level-solve");
    });
    row->Add(solve_);
    medals_ = button("Medals", "Enter the times that the proof suggests", "level-medals");
    row->Add(medals_);
    row->Add(button("Publish", "Put the level into the game's own menu", "level-publish"));
    sizer->Add(row, wxSizerFlags(0).Expand());
    proof_ =
        new wxStaticText(this, wxID_ANY, "", wxDefaultPosition, wxDefaultSize, wxST_NO_AUTORESIZE);
    sizer->Add(proof_, wxSizerFlags(0).Expand().Border(wxTOP, FromDIP(4)));
    gauge_ = new wxGauge(this, wxID_ANY, 100, wxDefaultPosition, FromDIP(wxSize(-1, 6)));
    sizer->Add(gauge_, wxSizerFlags(0).Expand().Border(wxTOP | wxBOTTOM, FromDIP(4)));
}

void LevelPanel::makeLists(wxSizer* sizer) {
    problemsTitle_ = heading("Problems");
    sizer->Add(problemsTitle_, wxSizerFlags(0).Expand());
    problems_ = new wxListBox(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(60, 76)), 0,
                              nullptr, wxLB_SINGLE);
    problems_->SetToolTip(wxTr("A click goes to what is wrong"));
    problems_->Bind(wxEVT_LISTBOX, [this](wxCommandEvent& event) {
        const auto place = static_cast<std::size_t>(std::max(0, event.GetInt()));
        if (place < shownProblems_.size()) problems_->SetToolTip(shownText(shownProblems_[place]));
        stage_.goTo(place);
    });
    sizer->Add(problems_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    sizer->Add(heading("Things"), wxSizerFlags(0).Expand());
    things_ = new wxListBox(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(60, 130)), 0, nullptr,
                            wxLB_SINGLE);
    things_->Bind(wxEVT_LISTBOX, [this](wxCommandEvent& event) {
        const auto place = static_cast<std::size_t>(std::max(0, event.GetInt()));
        if (place < listed_.size()) stage_.goTo(listed_[place]);
        refreshFields();
    });
    sizer->Add(things_, wxSizerFlags(0).Expand().Border(wxBOTTOM, FromDIP(6)));
    fieldsTitle_ = heading("");
    sizer->Add(fieldsTitle_, wxSizerFlags(0).Expand());
    fields_ = new wxFlexGridSizer(2, FromDIP(3), FromDIP(6));
    fields_->AddGrowableCol(1);
    sizer->Add(fields_, wxSizerFlags(0).Expand());
}

// --- fields ----------------------------------------------------------------------------------

void LevelPanel::enter(const LevelField& field, const std::string& text) {
    if (!shownThing_) return;
    const auto thing = *shownThing_;
    const auto now = fieldText(bench_.document(), thing, field);
    if (!now || *now == text) return;
    try {
        changeField(bench_.document(), thing, field, text);
    } catch (const std::exception& problem) {
        refuse_(problem.what());
        for (Row& row : rows_) row.shown = "\x01";  // what was refused is not kept
    }
    CallAfter([this] { refreshFields(); });
}

wxWindow* LevelPanel::makeField(const LevelField& field, const std::string& text) {
    if (field.type == FieldType::flag || field.type == FieldType::part) {
        auto* box = new wxCheckBox(this, wxID_ANY, "");
        box->SetValue(text == "yes");
        box->Bind(wxEVT_CHECKBOX, [this, &field](wxCommandEvent& event) {
            enter(field, event.IsChecked() ? "yes" : "no");
        });
        return box;
    }
    if (field.type == FieldType::choice) {
        auto* choice = new wxChoice(this, wxID_ANY, wxDefaultPosition, FromDIP(wxSize(60, -1)),
                                    wordsOf(field));
        select(choice, field, text);
        choice->Bind(wxEVT_CHOICE, [this, &field, choice](wxCommandEvent&) {
            const auto at = static_cast<std::size_t>(std::max(0, choice->GetSelection()));
            enter(field, choicesOf(field).at(at));
        });
        return choice;
    }
    const bool lines = field.type == FieldType::lines;
    auto* entry = new wxTextCtrl(this, wxID_ANY, shownText(text), wxDefaultPosition,
                                 FromDIP(wxSize(60, lines ? 60 : -1)),
                                 lines ? wxTE_MULTILINE : wxTE_PROCESS_ENTER);
    const auto take = [this, &field, entry] { enter(field, entry->GetValue().utf8_string()); };
    if (!lines) entry->Bind(wxEVT_TEXT_ENTER, [take](wxCommandEvent&) { take(); });
    entry->Bind(wxEVT_KILL_FOCUS, [take, entry](wxFocusEvent& event) {
        if (entry->IsModified()) take();
        event.Skip();
    });
    return entry;
}

void LevelPanel::makeFields() {
    fields_->Clear(true);
    rows_.clear();
    if (!shownThing_) return;
    for (const LevelField& field : levelFields()) {
        if (field.kind != shownThing_->kind) continue;
        const auto text = fieldText(bench_.document(), *shownThing_, field);
        if (!text) continue;
        wxString name = wxTr(field.name);
        if (!field.unit.empty()) name += " (" + shownText(field.unit) + ")";
        if (!field.needs.empty()) name = "   " + name;
        auto* label = new wxStaticText(this, wxID_ANY, name);
        wxWindow* window = makeField(field, *text);
        if (!field.help.empty()) {
            label->SetToolTip(wxTr(field.help));
            window->SetToolTip(wxTr(field.help));
        }
        fields_->Add(label, wxSizerFlags(0).CentreVertical());
        fields_->Add(window, wxSizerFlags(1).Expand());
        rows_.push_back({&field, window, *text});
    }
}

// What is typed is left alone until the document says something else.
void LevelPanel::refreshFields() {
    const Document& document = bench_.document();
    std::optional<LevelThing> thing;
    if (!bench_.things().empty() && contains(document, bench_.things().front()))
        thing = bench_.things().front();
    std::size_t wanted = 0;
    if (thing)
        for (const LevelField& field : levelFields())
            if (field.kind == thing->kind && fieldText(document, *thing, field)) ++wanted;
    if (thing != shownThing_ || wanted != rows_.size()) {
        shownThing_ = thing;
        fieldsTitle_->SetLabel(thing ? shownText(titleOf(document, *thing)) : wxString());
        makeFields();
        FitInside();
        Layout();
        return;
    }
    for (Row& row : rows_) {
        const std::string now = fieldText(document, *thing, *row.field).value_or("");
        if (now == row.shown) continue;
        row.shown = now;
        if (auto* box = dynamic_cast<wxCheckBox*>(row.window)) box->SetValue(now == "yes");
        if (auto* choice = dynamic_cast<wxChoice*>(row.window)) select(choice, *row.field, now);
        if (auto* entry = dynamic_cast<wxTextCtrl*>(row.window)) {
            entry->ChangeValue(shownText(now));
            entry->DiscardEdits();
        }
    }
}

// --- showing ---------------------------------------------------------------------------------

void LevelPanel::refreshProof() {
    const LevelDesk& desk = stage_.desk();
    const SearchJob* job = desk.job();
    const bool running = job != nullptr && !job->progress().over();
    const wxString label = wxTr(running ? "Stop the search" : "Can it be finished?");
    if (solve_->GetLabel() != label) solve_->SetLabel(label);
    medals_->Enable(desk.proof() == LevelDesk::Proof::holds);
    const int share = running ? static_cast<int>(std::lround(100 * job->progress().share)) : 0;
    if (gauge_->GetValue() != share) gauge_->SetValue(share);
    gauge_->Enable(running);
    const std::string text = desk.proofText();
    if (text == shownProof_) return;
    shownProof_ = text;
    proofWidth_ = 0;
    wrapProof();
}

// The width changes with the window and with the scroll bar.
void LevelPanel::wrapProof() {
    const int width = std::max(FromDIP(160), GetClientSize().GetWidth() - FromDIP(20));
    if (std::exchange(proofWidth_, width) == width) return;
    showWrapped(*proof_, shownText(shownProof_), width);
    FitInside();
    Layout();
}

void LevelPanel::refreshProblems() {
    const LevelDesk& desk = stage_.desk();
    std::vector<std::string> lines;
    for (const LevelProblem& problem : desk.problems())
        lines.push_back((problem.grave ? "\xE2\x9C\x95 " : "\xE2\x80\xA2 ") + problem.text);
    const wxString title = !desk.checked() ? wxTr("Problems\xE2\x80\xA6")
                           : lines.empty() ? wxTr("No problems")
                                           : wxTr("Problems: {}", {std::to_string(lines.size())});
    if (problemsTitle_->GetLabel() != title) problemsTitle_->SetLabel(title);
    if (lines == shownProblems_) return;
    setLines(problems_, lines);
    shownProblems_ = std::move(lines);
}

void LevelPanel::refreshThings() {
    const Document& document = bench_.document();
    auto things = levelThings(document);
    std::vector<std::string> lines;
    for (const LevelThing& thing : things) lines.push_back(titleOf(document, thing));
    if (lines != shownThings_) {
        setLines(things_, lines);
        shownThings_ = std::move(lines);
    }
    listed_ = std::move(things);
    int selected = wxNOT_FOUND;
    if (!bench_.things().empty()) {
        const auto found = std::find(listed_.begin(), listed_.end(), bench_.things().front());
        if (found != listed_.end()) selected = static_cast<int>(found - listed_.begin());
    }
    if (things_->GetSelection() == selected) return;
    things_->SetSelection(selected);
    if (selected != wxNOT_FOUND) things_->EnsureVisible(selected);
}

void LevelPanel::refresh() {
    const bool level = isLevel(bench_.document());
    if (wasLevel_ != level) {
        wasLevel_ = level;
        start_->ShowItems(!level);
        level_->ShowItems(level);
        FitInside();
        Layout();
    }
    if (!level) {
        shownThing_.reset();
        makeFields();
        return;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        pieces_[i]->SetValue(bench_.placing() == levelPieces()[i].piece);
    refreshProof();
    refreshProblems();
    refreshThings();
    refreshFields();
}

}  // namespace sulfurchamber
